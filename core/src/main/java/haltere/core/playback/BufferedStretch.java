package haltere.core.playback;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import java.util.OptionalLong;

/** Plays a copy of kept events and samples. */
final class BufferedStretch implements Playable {
  private final String name;
  private final SensorGeometry geometry;
  private final EventHistory events;
  private final EventPacket packet = new EventPacket(PlaybackEngine.CHUNK_EVENTS);
  private boolean started;
  private boolean resetPending;
  private boolean ended;
  private long offsetUs;

  BufferedStretch(Playable of, EventHistory events) {
    name = of.name();
    geometry = of.geometry();
    this.events = events;
    offsetUs = events.isEmpty() ? 0 : events.firstOffsetUs();
  }

  @Override
  public String name() {
    return name;
  }

  @Override
  public SensorGeometry geometry() {
    return geometry;
  }

  @Override
  public OptionalLong durationUs() {
    return OptionalLong.of(events.isEmpty() ? 0 : events.lastUs() + 1);
  }

  @Override
  public boolean seekable() {
    return true;
  }

  @Override
  public void seek(long elapsedUs) {
    events.read(elapsedUs);
    resetPending = started && !ended;
    started &= !ended;
    ended = false;
  }

  @Override
  public boolean next(StreamHandler handler) {
    if (ended) {
      return false;
    }
    if (!started) {
      started = true;
      handler.notified(new StreamStarted(geometry, name));
    } else if (resetPending) {
      resetPending = false;
      handler.notified(new Reset(Reset.Cause.SEEK));
    } else if (events.atEnd()) {
      ended = true;
      handler.notified(new EndOfStream(StreamNotification.NO_TIME_US));
    } else {
      events.next(packet, offset -> offsetUs = offset, handler);
    }
    return true;
  }

  @Override
  public long elapsedUs(long timeUs) {
    return timeUs + offsetUs;
  }

  @Override
  public void close() {}
}
