package haltere.core.playback;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import java.io.IOException;
import java.util.function.LongSupplier;

/**
 * Reads one packet, sample or notification of a playable ahead and passes it on in pieces.
 * Notifications after a seek or at the start are removed, since the player sends its own. Measures
 * the time spent in the playable.
 *
 * <p>Thread rule: the processing thread only.
 */
final class SourceCursor implements StreamHandler {
  /** Kind of the next element. */
  enum Ahead {
    EVENTS,
    SAMPLE,
    NOTIFICATION,
    END,
    /** Not known yet: ask again. */
    UNKNOWN
  }

  private final Playable playable;
  private final LongSupplier nanoTime;
  private final EventPacket pending = new EventPacket(PlaybackEngine.CHUNK_EVENTS);
  private final EventPacket piece = new EventPacket(PlaybackEngine.CHUNK_EVENTS);
  private int index;
  private int limit;
  private SensorSample sample;
  private StreamNotification notification;
  private StreamStarted start;
  private EndOfStream end;
  private boolean jumpExpected = true;
  private long offsetUs;
  private long busyNanos;

  SourceCursor(Playable playable, LongSupplier nanoTime) {
    this.playable = playable;
    this.nanoTime = nanoTime;
    start = new StreamStarted(playable.geometry(), playable.name());
  }

  /** Looks ahead; reads at most one packet. */
  Ahead ahead() throws IOException {
    Ahead known = known();
    if (known != Ahead.UNKNOWN) {
      return known;
    }
    long beginNanos = nanoTime.getAsLong();
    boolean more = playable.next(this);
    busyNanos += nanoTime.getAsLong() - beginNanos;
    if (!more) {
      end = new EndOfStream(StreamNotification.NO_TIME_US);
    }
    return known();
  }

  private Ahead known() {
    if (index < limit) {
      return Ahead.EVENTS;
    }
    if (sample != null) {
      return Ahead.SAMPLE;
    }
    if (notification != null) {
      return Ahead.NOTIFICATION;
    }
    return end != null ? Ahead.END : Ahead.UNKNOWN;
  }

  @Override
  public void packet(EventPacket packet) {
    jumpExpected = false;
    if (packet.isEmpty()) {
      return;
    }
    pending.clear();
    pending.append(packet, 0, packet.size());
    index = 0;
    limit = pending.size();
    offsetUs = playable.elapsedUs(pending.timeUs(0)) - pending.timeUs(0);
  }

  @Override
  public void sample(SensorSample given) {
    jumpExpected = false;
    sample = given;
    offsetUs = playable.elapsedUs(given.timeUs()) - given.timeUs();
  }

  @Override
  public void notified(StreamNotification given) {
    boolean expected = jumpExpected;
    jumpExpected = false;
    if (given instanceof EndOfStream last) {
      end = last;
    } else if (given instanceof StreamStarted started) {
      start = started;
      if (!expected) {
        notification = new Reset(Reset.Cause.SOURCE_CHANGED);
      }
    } else if (!(expected && given instanceof Reset reset && reset.cause() == Reset.Cause.SEEK)) {
      notification = given;
    }
  }

  /** Moves to a position; a failure changes nothing. */
  void seek(long elapsedUs) throws IOException {
    playable.seek(elapsedUs);
    index = 0;
    limit = 0;
    sample = null;
    notification = null;
    end = null;
    jumpExpected = true;
  }

  /** The earliest position that can be reached at once. */
  long earliestUs() {
    return playable.earliestUs();
  }

  /** Real time spent in the playable, nanoseconds. */
  long busyNanos() {
    return busyNanos;
  }

  /** The last start of the stream by the source. */
  StreamStarted start() {
    return start;
  }

  /** The end of the stream, when it is ahead. */
  EndOfStream end() {
    return end;
  }

  /** Takes the notification that is ahead. */
  StreamNotification takeNotification() {
    StreamNotification taken = notification;
    notification = null;
    return taken;
  }

  /** Takes the sample that is ahead. */
  SensorSample takeSample() {
    SensorSample taken = sample;
    sample = null;
    return taken;
  }

  /** Elapsed time of the sample that is ahead. */
  long sampleElapsedUs() {
    return sample.timeUs() + offsetUs;
  }

  /** Time of the event that is ahead. */
  long timeUs() {
    return pending.timeUs(index);
  }

  /** Elapsed time of the event that is ahead. */
  long elapsedUs() {
    return pending.timeUs(index) + offsetUs;
  }

  /** Elapsed time minus time in the stretch of the last packet. */
  long offsetUs() {
    return offsetUs;
  }

  /** Number of events ahead that lie before a position of the elapsed timeline. */
  int countBefore(long elapsedUs) {
    if (elapsedUs == Long.MAX_VALUE || pending.timeUs(limit - 1) < elapsedUs - offsetUs) {
      return limit - index;
    }
    return pending.indexAtOrAfter(elapsedUs - offsetUs, index) - index;
  }

  /** Takes events that are ahead; the packet may be changed until the next call. */
  EventPacket take(int count) {
    if (index == 0 && count == limit) {
      limit = 0;
      return pending;
    }
    piece.clear();
    piece.append(pending, index, index + count);
    index += count;
    return piece;
  }

  /** Skips events that are ahead. */
  void skip(int count) {
    index += count;
  }
}
