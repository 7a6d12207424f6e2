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
 * A source that cannot be sought, such as a camera or a scene, whose newest events are kept, and
 * the samples (frames, inertial samples, triggers) between them, so that one can go back to them,
 * play them again at any speed, loop a part of them and take a copy. Behind the newest of them it
 * continues with what the source gives then. A camera that is not listened to meanwhile loses what
 * it loses in a pause, and says so.
 *
 * <p>Thread rule: as {@link Playable}; {@link #isLive()}, {@link #keptFromUs()} and {@link
 * #keptToUs()} from any thread.
 *
 * @since 0.1
 */
public final class KeptPlayable implements Playable {
  private final Playable source;
  private final EventHistory history;
  private final EventPacket again = new EventPacket(PlaybackEngine.CHUNK_EVENTS);
  private final Keeper keeper = new Keeper();
  private volatile boolean replaying;
  private volatile long keptFromUs;
  private volatile long keptToUs;
  private long offsetUs;
  private StreamStarted start;
  private StreamNotification jump;
  private EndOfStream end;
  private boolean endGiven;

  /**
   * Keeps what a source gives from now on.
   *
   * @param source at its start; closed with this
   * @param mostEvents so many of its newest events are kept, at 8 bytes each; at least some ten
   *     thousand. Samples are kept as long as the events beside them, in at most 72 MB
   */
  public KeptPlayable(Playable source, int mostEvents) {
    this.source = Objects.requireNonNull(source, "source");
    history = new EventHistory(mostEvents);
  }

  /**
   * The source.
   *
   * @return to be asked who it is; its stream is this one's
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
   * Place of the oldest event that is kept.
   *
   * @return microseconds on the elapsed timeline; 0 before the first event
   */
  public long keptFromUs() {
    return keptFromUs;
  }

  /**
   * Place just behind the newest event.
   *
   * @return microseconds on the elapsed timeline; 0 before the first event
   */
  public long keptToUs() {
    return keptToUs;
  }

  @Override
  public long earliestUs() {
    return keptFromUs;
  }

  /** {@inheritDoc} A scene's start can be gone to even where it is not kept: it is made anew. */
  @Override
  public long nearestUs(long elapsedUs) {
    return elapsedUs <= 0 && !source.isLive()
        ? 0
        : Math.max(keptFromUs, Math.min(keptToUs, elapsedUs));
  }

  @Override
  public void seek(long elapsedUs) throws IOException {
    if (history.isEmpty() || elapsedUs < keptFromUs) {
      if (elapsedUs != 0 || !history.isEmpty() && source.isLive()) {
        throw new IOException(
            name() + " keeps only its last moments, from " + keptFromUs + " us on");
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
      StreamNotification said = jump;
      jump = null;
      handler.notified(said);
      return true;
    }
    // not before the last piece has been asked for and played: until then it is paced
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
    keptFromUs = history.isEmpty() ? 0 : history.fromUs();
    keptToUs = history.isEmpty() ? 0 : history.lastUs() + 1;
  }

  /** Keeps what the source gives on its way. */
  private final class Keeper implements StreamHandler {
    private StreamHandler handler;

    Keeper of(StreamHandler newHandler) {
      handler = newHandler;
      return this;
    }

    @Override
    public void packet(EventPacket packet) {
      if (!packet.isEmpty()) {
        offsetUs = source.elapsedUs(packet.firstTimeUs()) - packet.firstTimeUs();
        history.append(packet, offsetUs);
        published();
      }
      handler.packet(packet);
    }

    @Override
    public void sample(SensorSample sample) {
      offsetUs = source.elapsedUs(sample.timeUs()) - sample.timeUs();
      history.append(sample, offsetUs);
      handler.sample(sample);
    }

    @Override
    public void notified(StreamNotification notification) {
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
   * A copy of what is kept of a half-open stretch, which stays when more events come. On the thread
   * that plays this.
   *
   * @param fromUs its start on the elapsed timeline; earlier than what is kept means from there
   * @param toUs its end, not included
   * @return the same timeline, with nothing before and behind the stretch
   */
  public Playable copy(long fromUs, long toUs) {
    return new KeptStretch(this, history.copy(fromUs, toUs));
  }

  @Override
  public void close() throws IOException {
    source.close();
  }
}
