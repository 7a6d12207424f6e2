package haltere.core.simulation.internal.flight;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.simulation.SceneRuns;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The flight is realistic, and all cameras see the same one. */
class FlightSceneTest {
  private static FlightScene scene(String... assignments) {
    return new FlightScene(FlightSettings.defaults().with(assignments));
  }

  @Test
  void eventsAreReproducibleAndCamerasSeeTheSameFlight() {
    EventPacket first = SceneRuns.events(scene("run.durationS=0.2"));
    assertEquals(first, SceneRuns.events(scene("run.durationS=0.2")));
    FlightScene other = scene("run.durationS=0.2", "view.camera=1");
    assertEquals(scene().truthAt(70_000), other.truthAt(70_000));
    assertEquals(scene().detections(3), other.detections(3));
    assertNotEquals(first, SceneRuns.events(other));
    assertTrue(first.size() > 1000, first.size() + " events");
  }

  @Test
  void eventsLieOnTheContourOfTheBody() {
    FlightScene scene =
        scene(
            "run.durationS=0.5",
            "noise.leakHz=0",
            "noise.shotHz=0",
            "noise.hotPixels=0",
            "view.cameras=2");
    EventPacket events = SceneRuns.events(scene);
    FlightCamera camera = scene.cameras().get(0);
    double[] pixel = new double[2];
    for (int i = 0; i < events.size(); i++) {
      FlightTruth truth = scene.truthAt(events.timeUs(i));
      camera.project(new double[] {truth.xM(), truth.yM(), truth.zM()}, pixel);
      double away = Math.hypot(events.x(i) - pixel[0], events.y(i) - pixel[1]);
      assertTrue(away < 16, "an event " + away + " px from the middle of the body");
    }
  }

  @Test
  void axisIsAUnitVectorInFlightDirectionWithinTheRoom() {
    for (long seed = 1; seed <= 20; seed++) {
      FlightScene scene = scene("run.seed=" + seed);
      for (long timeUs = 0; timeUs < 20_000_000; timeUs += 37_000) {
        FlightTruth truth = scene.truthAt(timeUs);
        double length = Math.sqrt(dot(truth, truth.ux(), truth.uy(), truth.uz()));
        assertEquals(1, length, 1e-12);
        double forwards =
            truth.vxMS() * truth.ux() + truth.vyMS() * truth.uy() + truth.vzMS() * truth.uz();
        assertTrue(forwards > 0, "seed " + seed + " at " + timeUs);
        double away = Math.hypot(Math.hypot(truth.xM(), truth.yM()), truth.zM());
        assertTrue(away < 0.15 * 1.3, away + " m from the middle");
      }
    }
  }

  private static double dot(FlightTruth truth, double x, double y, double z) {
    return truth.ux() * x + truth.uy() * y + truth.uz() * z;
  }

  @Test
  void detectionsHaveTheConfiguredNoiseOutliersAndGaps() {
    FlightScene noisy = scene("view.cameras=4");
    FlightScene exact =
        scene(
            "view.cameras=4",
            "detection.angleSdDeg=0",
            "detection.placeSdPx=0",
            "detection.outlierShare=0",
            "detection.missingShare=0");
    boolean[] outlier = new boolean[4];
    double squares = 0;
    int inliers = 0;
    int outliers = 0;
    int seen = 0;
    for (long k = 0; k < 2000; k++) {
      List<FlightDetection> truth = exact.detections(k);
      for (FlightDetection each : noisy.detections(k, outlier)) {
        int camera = Integer.parseInt(each.camera().substring("camera-".length()));
        double off = Math.IEEEremainder(each.angleRad() - truth.get(camera).angleRad(), Math.PI);
        seen++;
        if (outlier[camera]) {
          outliers++;
          assertTrue(Math.abs(off) >= Math.toRadians(20) - 1e-9);
        } else {
          inliers++;
          squares += off * off;
        }
      }
    }
    assertEquals(2, Math.toDegrees(Math.sqrt(squares / inliers)), 0.1);
    assertEquals(0.1, (double) outliers / seen, 0.01);
    assertEquals(0.95, seen / 8000.0, 0.01);
  }

  @Test
  void unknownCamerasAndOversizedRoomsAreRejected() {
    assertThrows(IllegalArgumentException.class, () -> scene("view.cameras=2", "view.camera=2"));
    assertThrows(IllegalArgumentException.class, () -> scene("view.roomM=0.55"));
  }
}
