package haltere.ui.viewer.space;

import haltere.core.camera.Camera;
import haltere.core.camera.CameraInfo;
import haltere.core.camera.CameraOptions;
import haltere.core.camera.CameraProvider;
import haltere.core.camera.CameraStatistics;
import haltere.core.camera.ClockRelation;
import haltere.core.event.EventPacket;
import haltere.core.simulation.internal.flight.FlightScene;
import haltere.core.simulation.internal.flight.FlightSettings;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.IntStream;

/** Cameras that look at the same simulated flight in real time, each by a clock of its own. */
final class FlightCameras implements CameraProvider {
  /** By so much the clock of each camera is ahead of the one before. */
  private static final long CLOCKS_APART_US = 1_234_567;

  private final FlightSettings settings;
  private final long startNanos = System.nanoTime();

  FlightCameras(FlightSettings settings) {
    this.settings = settings;
  }

  @Override
  public String name() {
    return "flight";
  }

  @Override
  public List<CameraInfo> list() {
    FlightScene scene = new FlightScene(settings);
    return scene.cameras().stream()
        .map(camera -> new CameraInfo(camera.id(), "flight", "", scene.geometry(), true, ""))
        .toList();
  }

  @Override
  public Camera open(CameraInfo info, CameraOptions options) {
    int number =
        IntStream.range(0, settings.view().cameras())
            .filter(i -> list().get(i).id().equals(info.id()))
            .findFirst()
            .orElseThrow();
    return new Seeing(info, number);
  }

  private final class Seeing implements Camera, StreamHandler {
    private final CameraInfo info;
    private final long clockUs;
    private final FlightScene scene;
    private EventPacket packet;
    private StreamNotification notification;

    Seeing(CameraInfo info, int number) {
      this.info = info;
      clockUs = number * CLOCKS_APART_US;
      scene = new FlightScene(settings.with("view.camera=" + number, "run.startUs=" + clockUs));
    }

    @Override
    public CameraInfo info() {
      return info;
    }

    @Override
    public boolean await(long nanos) {
      if (packet == null && notification == null && !scene.next(this)) {
        return true;
      }
      long dueNanos = packet == null || packet.isEmpty() ? startNanos : due(packet.lastTimeUs());
      long waitNanos = dueNanos - System.nanoTime();
      LockSupport.parkNanos(Math.min(nanos, waitNanos));
      return waitNanos <= 0;
    }

    private long due(long timeUs) {
      return startNanos + TimeUnit.MICROSECONDS.toNanos(timeUs - clockUs);
    }

    @Override
    public boolean next(StreamHandler handler) throws IOException {
      while (!await(TimeUnit.MILLISECONDS.toNanos(1))) {
        // its time will come
      }
      boolean isThere = packet != null || notification != null;
      if (packet != null) {
        handler.packet(packet);
      } else if (notification != null) {
        handler.notified(notification);
      }
      packet = null;
      notification = null;
      return isThere;
    }

    @Override
    public void packet(EventPacket made) {
      packet = made.copy();
    }

    @Override
    public void notified(StreamNotification made) {
      notification = made;
    }

    @Override
    public <F> Optional<F> facet(Class<F> facet) {
      return Optional.empty();
    }

    @Override
    public CameraStatistics statistics() {
      return CameraStatistics.NONE;
    }

    @Override
    public Optional<ClockRelation> clockRelation() {
      return Optional.of(new ClockRelation(clockUs, startNanos));
    }

    @Override
    public void close() {
      // a scene holds nothing
    }
  }
}
