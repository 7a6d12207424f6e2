package haltere.core.playback;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import java.io.IOException;
import java.util.Objects;
import java.util.OptionalLong;

/**
 * Makes a source without seeking, such as a camera or a scene, seekable within its newest events
 * and samples. They can be replayed at any speed, looped and copied. After the newest of them,
 * playback continues with the source. While a camera is not read, it loses events as in a pause,
 * and reports them.
 *
 * <p>Thread rule: as {@link Playable}; {@link #isLive()}, {@link #bufferedFromUs()} and {@link
 * #bufferedToUs()} from any thread.
 *
 * @since 0.1
 */
public final class BufferedPlayable implements Playable {
  private final Playable source;
  private final EventHistory history;
  private final EventPacket again = new EventPacket(PlaybackEngine.CHUNK_EVENTS);
  private final Keeper keeper = new Keeper();
  private final int maxEvents;
  private volatile boolean replaying;
  private volatile long bufferedFromUs;
  private volatile long bufferedToUs;
  private long offsetUs;
  private StreamStarted start;
  private StreamNotification jump;
  private EndOfStream end;
  private boolean endGiven;

  /**
   * Starts to keep the events of a source.
   *
   * @param source at its start; closed with this
   * @param maxEvents approximate number of events to keep, 8 bytes each, raised to two chunks of
   *     8,192. Samples are kept as long as the events beside them, in at most 72 MB
   */
  public BufferedPlayable(Playable source, int maxEvents) {
    this.source = Objects.requireNonNull(source, "source");
    this.maxEvents = maxEvents;
    history = new EventHistory(maxEvents);
  }

  /**
   * The source.
   *
   * @return for its properties; only this playable may read its stream
   */
  public Playable source() {
    return source;
  }

  @Override
  public String name() {
    return source.name();
  }

  @Override
  public SensorGeometry geometry() {
    return source.geometry();
  }

  @Override
  public OptionalLong durationUs() {
    return source.durationUs();
  }

  @Override
  public boolean seekable() {
    return true;
  }

  @Override
  public boolean isLive() {
    return source.isLive() && !replaying;
  }

  /**
   * Position of the oldest event that is kept.
   *
   * @return microseconds on the elapsed timeline; 0 before the first event
   */
  public long bufferedFromUs() {
    return bufferedFromUs;
  }

  /**
   * Position just after the newest event.
   *
   * @return microseconds on the elapsed timeline; 0 before the first event
   */
  public long bufferedToUs() {
    return bufferedToUs;
  }

  @Override
  public long earliestUs() {
    return bufferedFromUs;
  }

  /** {@inheritDoc} The start of a scene can always be reached: the scene is created again. */
  @Override
  public long nearestUs(long elapsedUs) {
    return elapsedUs <= 0 && !source.isLive()
        ? 0
        : Math.max(bufferedFromUs, Math.min(bufferedToUs, elapsedUs));
  }

  /** {@inheritDoc} Of a live source, at most as many events as are kept. */
  @Override
  public void catchUp() throws IOException {
    long before = history.events();
    do {
      keeper.hasKept = false;
    } while (source.isLive()
        && end == null
        && history.events() - before < maxEvents
        && source.next(keeper.of(packet -> {}))
        && keeper.hasKept);
  }

  @Override
  public void seek(long elapsedUs) throws IOException {
    if (history.isEmpty() || elapsedUs < bufferedFromUs) {
      if (elapsedUs != 0 || !history.isEmpty() && source.isLive()) {
        throw new IOException(
            name() + " keeps only its last moments, from " + bufferedFromUs + " us on");
      }
      source.seek(0);
      history.clear();
      published();
      end = null;
      replaying = false;
      jump = null;
      return;
    }
    history.read(elapsedUs);
    replaying = !history.atEnd();
    jump = endGiven ? start : new Reset(Reset.Cause.SEEK);
    endGiven = false;
  }

  @Override
  public boolean next(StreamHandler handler) throws IOException {
    if (jump != null) {
      StreamNotification current = jump;
      jump = null;
      handler.notified(current);
      return true;
    }
    // Replay ends with the request after its last piece, so that this piece is paced too.
    replaying &= !history.atEnd();
    if (replaying) {
      history.next(again, offset -> offsetUs = offset, handler);
      return true;
    }
    if (end != null) {
      if (!endGiven) {
        endGiven = true;
        handler.notified(end);
        return true;
      }
      return false;
    }
    return source.next(keeper.of(handler));
  }

  private void published() {
    bufferedFromUs = history.isEmpty() ? 0 : history.fromUs();
    bufferedToUs = history.isEmpty() ? 0 : history.lastUs() + 1;
  }

  /** Keeps the elements of the source and passes them on. */
  private final class Keeper implements StreamHandler {
    private StreamHandler handler;
    private boolean hasKept;

    Keeper of(StreamHandler newHandler) {
      handler = newHandler;
      return this;
    }

    @Override
    public void packet(EventPacket packet) {
      if (!packet.isEmpty()) {
        hasKept = true;
        offsetUs = source.elapsedUs(packet.firstTimeUs()) - packet.firstTimeUs();
        history.append(packet, offsetUs);
        published();
      }
      handler.packet(packet);
    }

    @Override
    public void sample(SensorSample sample) {
      hasKept = true;
      offsetUs = source.elapsedUs(sample.timeUs()) - sample.timeUs();
      history.append(sample, offsetUs);
      handler.sample(sample);
    }

    @Override
    public void notified(StreamNotification notification) {
      hasKept = true;
      if (notification instanceof EndOfStream last) {
        end = last;
        endGiven = true;
      } else if (notification instanceof StreamStarted first) {
        start = first;
      } else {
        history.append(notification);
      }
      handler.notified(notification);
    }
  }

  @Override
  public long elapsedUs(long timeUs) {
    return timeUs + offsetUs;
  }

  /**
   * Copies a half-open interval of the kept events, independent of later events. Called on the
   * thread that plays this.
   *
   * @param fromUs its start on the elapsed timeline; raised to the oldest kept event
   * @param toUs its end, not included
   * @return the same timeline, with nothing before and after the interval
   */
  public Playable copy(long fromUs, long toUs) {
    return new BufferedStretch(this, history.copy(fromUs, toUs));
  }

  @Override
  public void close() throws IOException {
    source.close();
  }
}
