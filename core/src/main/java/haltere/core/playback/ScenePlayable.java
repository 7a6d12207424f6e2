package haltere.core.playback;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.EventSource;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.util.Objects;
import java.util.OptionalLong;
import java.util.function.Supplier;

/**
 * A simulated scene as a playable: without end; to go back to its start, it is created again. Its
 * elapsed timeline starts at its first event, and where its clock restarts it continues 1 us behind
 * the last event.
 *
 * <p>Thread rule: as {@link Playable}.
 *
 * @since 0.1
 */
public final class ScenePlayable implements Playable {
  private final Supplier<? extends EventSource> scenes;
  private final String name;
  private final ElapsedTimeline timeline = new ElapsedTimeline();
  private EventSource scene;

  /**
   * A scene at its start.
   *
   * @param scenes makes the same scene at every call
   * @param name for users
   */
  public ScenePlayable(Supplier<? extends EventSource> scenes, String name) {
    this.scenes = Objects.requireNonNull(scenes, "scenes");
    this.name = Objects.requireNonNull(name, "name");
    scene = scenes.get();
  }

  @Override
  public String name() {
    return name;
  }

  @Override
  public SensorGeometry geometry() {
    return scene.geometry();
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
  public void seek(long elapsedUs) throws IOException {
    if (elapsedUs != 0) {
      throw new IOException(name + " can go back to its start only, not to " + elapsedUs + " us");
    }
    scene.close();
    scene = scenes.get();
    timeline.begin();
  }

  @Override
  public boolean next(StreamHandler handler) throws IOException {
    return scene.next(
        new StreamHandler() {
          @Override
          public void packet(EventPacket packet) {
            timeline.packet(packet);
            handler.packet(packet);
          }

          @Override
          public void notified(StreamNotification notification) {
            if (notification instanceof haltere.core.stream.Reset) {
              timeline.clockRestarts();
            }
            handler.notified(notification);
          }
        });
  }

  @Override
  public long elapsedUs(long timeUs) {
    return timeline.elapsedUs(timeUs);
  }

  @Override
  public void close() throws IOException {
    scene.close();
  }
}
