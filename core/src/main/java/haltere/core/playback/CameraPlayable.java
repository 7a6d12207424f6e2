package haltere.core.playback;

import haltere.core.camera.Camera;
import haltere.core.camera.CameraOptions;
import haltere.core.camera.CameraProblem;
import haltere.core.camera.Cameras;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.stream.DeviceLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import java.io.IOException;
import java.util.Objects;
import java.util.OptionalLong;

/**
 * A camera as a playable: without end, and without seeking. Where its clock restarts, the elapsed
 * timeline continues 1 us behind the last event. A camera that was opened to reconnect and is
 * unplugged gives nothing until it is back; then a {@code Reset(CLOCK_RESTARTED)} separates the
 * events before and after, because for the user it is one session.
 *
 * <p>It never makes the player wait for more than some milliseconds, so that the player responds to
 * commands while there are no events.
 *
 * <p>Thread rule: as {@link Playable}; {@link #isUnplugged} from any thread.
 *
 * @since 0.1
 */
public final class CameraPlayable implements Playable {
  private static final long TIMEOUT_NANOS = 5_000_000;

  private final Camera camera;
  private final boolean reconnects;
  private final EventPacket nothing = new EventPacket(1);
  private final ElapsedTimeline timeline = new ElapsedTimeline();
  private volatile boolean unplugged;
  private boolean started;
  private long lastUs = StreamNotification.NO_TIME_US;

  /**
   * A camera to play.
   *
   * @param camera an open camera, closed with this
   * @param reconnects whether it was opened to continue when it is plugged in again
   */
  public CameraPlayable(Camera camera, boolean reconnects) {
    this.camera = Objects.requireNonNull(camera, "camera");
    this.reconnects = reconnects;
  }

  /**
   * The camera.
   *
   * @return for its properties and settings; only the player may read its stream
   */
  public Camera camera() {
    return camera;
  }

  /**
   * Whether the camera is unplugged and may come back.
   *
   * @return true from the notification of its loss until the notification of its restart
   */
  public boolean isUnplugged() {
    return unplugged;
  }

  /**
   * Opens a camera that continues when it is plugged in again, and loses the oldest events if this
   * computer does not keep up.
   *
   * @param cameras where it is
   * @param id its id
   * @return a playable of its events
   * @throws haltere.core.camera.CameraProblem if it cannot be opened
   */
  public static CameraPlayable open(Cameras cameras, String id) throws CameraProblem {
    CameraOptions options =
        CameraOptions.DEFAULT.withReconnect(true).withWhenFull(CameraOptions.WhenFull.DROP_OLDEST);
    return new CameraPlayable(cameras.open(id, options), true);
  }

  @Override
  public String name() {
    return camera.info().id();
  }

  @Override
  public SensorGeometry geometry() {
    return camera.geometry();
  }

  @Override
  public boolean isLive() {
    return true;
  }

  @Override
  public OptionalLong durationUs() {
    return OptionalLong.empty();
  }

  @Override
  public boolean seekable() {
    return false;
  }

  /** {@inheritDoc} A seek to 0 restarts the elapsed timeline at the next event. */
  @Override
  public void seek(long elapsedUs) throws IOException {
    if (elapsedUs != 0) {
      throw new IOException(name() + " is a camera: past events cannot be played again");
    }
    timeline.begin();
  }

  @Override
  public boolean next(StreamHandler handler) throws IOException {
    if (!camera.await(TIMEOUT_NANOS)) {
      handler.packet(nothing);
      return true;
    }
    return camera.next(new OneSession(handler));
  }

  /** Joins the streams before and after an unplugging. */
  private final class OneSession implements StreamHandler {
    private final StreamHandler handler;

    OneSession(StreamHandler handler) {
      this.handler = handler;
    }

    @Override
    public void packet(EventPacket packet) {
      if (!packet.isEmpty()) {
        lastUs = packet.lastTimeUs();
        timeline.packet(packet);
      }
      handler.packet(packet);
    }

    @Override
    public void sample(SensorSample sample) {
      handler.sample(sample);
    }

    @Override
    public void notified(StreamNotification notification) {
      if (notification instanceof DeviceLost && reconnects) {
        unplugged = true;
        handler.packet(nothing);
      } else if (notification instanceof EndOfStream && unplugged) {
        handler.packet(nothing);
      } else if (notification instanceof StreamStarted && started) {
        unplugged = false;
        restart(new Reset(Reset.Cause.CLOCK_RESTARTED, lastUs, StreamNotification.NO_TIME_US));
      } else if (notification instanceof Reset reset) {
        restart(reset);
      } else {
        started |= notification instanceof StreamStarted;
        handler.notified(notification);
      }
    }

    private void restart(Reset reset) {
      timeline.clockRestarts();
      handler.notified(reset);
    }
  }

  @Override
  public long elapsedUs(long timeUs) {
    return timeline.elapsedUs(timeUs);
  }

  @Override
  public void close() {
    camera.close();
  }
}
