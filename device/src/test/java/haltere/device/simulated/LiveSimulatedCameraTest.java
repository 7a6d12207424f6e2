package haltere.device.simulated;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.camera.Camera;
import haltere.core.camera.CameraInfo;
import haltere.core.camera.CameraOptions;
import haltere.core.camera.CameraStatistics;
import haltere.core.camera.Cameras;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.RunSettings;
import haltere.core.simulation.Scene;
import haltere.core.stream.DataLost;
import haltere.core.stream.DeviceLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.StreamGrammar;
import haltere.core.stream.StreamHandler;
import haltere.testing.ManualClock;
import haltere.testing.StreamRecorder;
import haltere.testing.Waiting;
import java.io.IOException;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Simulated cameras in real time: their clock continues whatever the consumer does. */
@Timeout(60)
class LiveSimulatedCameraTest {
  private final Cameras cameras = new Cameras(List.of(new SimulatedCameraProvider()));
  private final StreamRecorder recorder = new StreamRecorder();
  private final StreamGrammar stream = new StreamGrammar(recorder);

  private Camera dots(CameraOptions options) throws IOException {
    return cameras.open("simulated:dots", options);
  }

  private void untilOver(Camera camera) throws IOException {
    while (camera.next(stream)) {
      // to the end
    }
  }

  @Test
  void busyConsumerLosesCountedEventsWhileTheClockContinues() throws IOException {
    Camera camera = dots(CameraOptions.DEFAULT.withBuffers(0, 0, 5));
    while (recorder.events().isEmpty()) {
      camera.next(stream);
    }
    long zeroNanos = camera.clockRelation().orElseThrow().hostNanos();

    // nobody takes anything, and the camera continues
    Waiting.until("60 transfers", () -> camera.statistics().transfers() >= 60);
    assertTrue(camera.statistics().lostEvents() > 0);
    assertEquals(zeroNanos, camera.clockRelation().orElseThrow().hostNanos());
    camera.close();
    untilOver(camera);

    CameraStatistics statistics = camera.statistics();
    long reported =
        recorder.notifications(DataLost.class).stream().mapToLong(DataLost::estimatedEvents).sum();
    assertEquals(statistics.lostEvents(), reported);
    assertEquals(statistics.bytes() / 4, recorder.events().size() + reported);
  }

  @Test
  void unpluggedCameraIsSilentAndReconnectingStartsANewStream() throws IOException {
    try (Camera camera = dots(CameraOptions.DEFAULT.withReconnect(true))) {
      Plug plug = camera.facet(Plug.class).orElseThrow();
      while (recorder.events().isEmpty()) {
        camera.next(stream);
      }
      plug.unplug();
      while (recorder.notifications(EndOfStream.class).isEmpty()) {
        camera.next(stream);
      }
      assertFalse(camera.await(0));
      Thread plugging = new Thread(plug::plugIn);
      plugging.start();
      assertTrue(camera.await(TimeUnit.MINUTES.toNanos(1)));
      int before = recorder.events().size();
      while (recorder.events().size() == before) {
        camera.next(stream);
      }
      assertEquals(1, recorder.notifications(DeviceLost.class).size());
      assertEquals(2, camera.statistics().streams());
    }
  }

  @Test
  void closingEndsTheStreamOfAWaitingConsumer() throws Exception {
    Camera camera = dots(CameraOptions.DEFAULT.withReconnect(true));
    camera.next(stream);
    camera.facet(Plug.class).orElseThrow().unplug();
    Thread closer = new Thread(camera::close);
    closer.start();
    untilOver(camera);
    closer.join();
    assertEquals(1, recorder.notifications(EndOfStream.class).size());
  }

  // ---- Scenes that are not made in time, or not at all

  /** The truth of a scene that has none. */
  private record Nothing() {}

  /** An event each half millisecond; something happens while it is made. */
  private static final class HardScene implements Scene<Nothing> {
    private final Runnable meanwhile;
    private final EventPacket packet = new EventPacket(1);
    private long timeUs;

    HardScene(Runnable meanwhile) {
      this.meanwhile = meanwhile;
    }

    @Override
    public SensorGeometry geometry() {
      return new SensorGeometry(4, 4);
    }

    @Override
    public boolean next(StreamHandler handler) {
      meanwhile.run();
      timeUs += 500;
      packet.clear();
      packet.append(timeUs, 1, 2, true);
      handler.packet(packet);
      return true;
    }

    @Override
    public Class<Nothing> truthType() {
      return Nothing.class;
    }

    @Override
    public List<Nothing> truthRows(long atUs) {
      return List.of();
    }

    @Override
    public RunSettings run() {
      return RunSettings.defaults();
    }
  }

  private static CameraInfo info(Scene<?> scene) {
    return new CameraInfo("simulated:hard", "simulated camera", "", scene.geometry(), true, "");
  }

  @Test
  void slowSceneIsReportedAsLossWhileTheClockContinues() throws IOException {
    ManualClock time = new ManualClock();
    Scene<Nothing> scene = new HardScene(() -> time.advance(TimeUnit.MILLISECONDS.toNanos(300)));
    try (Camera camera =
        SimulatedCamera.stepped(info(scene), scene, CameraOptions.DEFAULT, time, time)) {
      while (recorder.events().size() < 50) {
        camera.next(stream);
      }
      long nowUs = TimeUnit.NANOSECONDS.toMicros(time.getAsLong());
      List<DataLost> reported = recorder.notifications(DataLost.class);
      assertFalse(reported.isEmpty());
      assertEquals(-1, reported.get(0).estimatedEvents());
      assertTrue(reported.get(0).place().contains("too slow to simulate"), reported.get(0).place());
      assertTrue(
          reported.get(0).toUs() > reported.get(0).fromUs() + 200_000, reported.get(0).toString());
      assertEquals(0, camera.clockRelation().orElseThrow().hostNanos(), "its clock is live");
      assertTrue(nowUs - recorder.events().lastTimeUs() < 1_500_000, "and so are its events");
      assertTrue(camera.statistics().brokenTransfers() >= reported.size());
    }
  }

  @Test
  void exceptionOfASceneReachesTheConsumer() {
    Scene<Nothing> scene =
        new HardScene(
            () -> {
              throw new UnsupportedOperationException("no dots today");
            });
    Camera camera = SimulatedCamera.live(info(scene), scene, CameraOptions.DEFAULT);
    Throwable cause = assertThrows(IllegalStateException.class, () -> untilOver(camera)).getCause();
    assertInstanceOf(UnsupportedOperationException.class, cause);
  }
}
