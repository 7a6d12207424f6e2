package haltere.core.playback;

import static haltere.core.playback.EngineRig.SENSOR;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.util.List;
import java.util.OptionalLong;

/** A source with a scripted stream. */
final class ScriptedPlayable implements Playable {
  private final List<Object> items;
  private int next;
  private final ElapsedTimeline timeline = new ElapsedTimeline();

  ScriptedPlayable(Object... items) {
    this.items = List.of(items);
  }

  @Override
  public String name() {
    return "script";
  }

  @Override
  public SensorGeometry geometry() {
    return SENSOR;
  }

  @Override
  public OptionalLong durationUs() {
    return OptionalLong.empty();
  }

  @Override
  public boolean seekable() {
    return false;
  }

  @Override
  public boolean isLive() {
    return true;
  }

  @Override
  public void seek(long elapsedUs) {
    timeline.begin();
  }

  @Override
  public boolean next(StreamHandler handler) {
    if (next == items.size()) {
      return false;
    }
    Object item = items.get(next++);
    if (item instanceof EventPacket packet) {
      timeline.packet(packet);
      handler.packet(packet.copy());
    } else if (item instanceof SensorSample sample) {
      handler.sample(sample);
    } else {
      if (item instanceof Reset) {
        timeline.clockRestarts();
      }
      handler.notified((StreamNotification) item);
    }
    return true;
  }

  @Override
  public long elapsedUs(long timeUs) {
    return timeline.elapsedUs(timeUs);
  }

  @Override
  public void close() {}
}
