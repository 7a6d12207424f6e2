package haltere.filters.orientation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.simulation.internal.flight.FlightScene;
import haltere.filters.orientation.camera.LineObservation;
import haltere.filters.orientation.camera.Vectors;
import haltere.filters.orientation.line.BodyLine;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class LiveOrientationTest {
  private static final int CAMERAS = 3;
  private final FlightScene scene =
      Flights.scene(CAMERAS, 3, "detection.outlierShare=0", "detection.missingShare=0");

  private BodyLine line(int camera, long picture) {
    LineObservation seen =
        Flights.observations(scene, scene.detections(picture)).stream()
            .filter(each -> each.camera() == camera)
            .findFirst()
            .orElseThrow();
    return new BodyLine(
        scene.pictureTimeUs(picture),
        seen.xPx(),
        seen.yPx(),
        seen.angleRad(),
        seen.areaPx(),
        seen.eccentricity(),
        0,
        0,
        20);
  }

  private List<OrientationEstimate> expected(int pictures) {
    BodyOrientationEstimator body =
        new BodyOrientationEstimator(Flights.cameras(scene), OrientationSettings.defaults());
    List<OrientationEstimate> all = new ArrayList<>();
    for (long k = 0; k < pictures; k++) {
      List<LineObservation> seen = Flights.observations(scene, scene.detections(k));
      body.update(scene.pictureTimeUs(k), seen).ifPresent(all::add);
    }
    return all;
  }

  @Test
  void orderOfCamerasDoesNotMatter() {
    SplittableRandom random = new SplittableRandom(1);
    List<OrientationEstimate> all = new ArrayList<>();
    LiveOrientation live =
        new LiveOrientation(
            Flights.cameras(scene),
            OrientationSettings.defaults(),
            50_000,
            (now, body) -> all.add(now));
    long[] next = new long[CAMERAS];
    while (next[0] + next[1] + next[2] < 3 * 60) {
      int camera = random.nextInt(CAMERAS);
      long slowest = Math.min(next[0], Math.min(next[1], next[2]));
      if (next[camera] < 60 && next[camera] < slowest + 4) {
        live.line(camera, line(camera, next[camera]++));
      }
    }
    live.finish();
    List<OrientationEstimate> expected = expected(60);
    assertEquals(expected.size(), all.size());
    for (int k = 0; k < all.size(); k++) {
      // the lines of one time come in another order, and the last digits with it
      double[] is = {all.get(k).ux(), all.get(k).uy(), all.get(k).uz()};
      double[] was = {expected.get(k).ux(), expected.get(k).uy(), expected.get(k).uz()};
      assertEquals(expected.get(k).timeUs(), all.get(k).timeUs());
      assertEquals(0, Math.toDegrees(Vectors.angle(is, was)), 0.2, "time " + k);
    }
    assertEquals(0, live.late());
  }

  @Test
  void silentCamerasDelayLittleAndTheirLateLinesAreCounted() {
    List<OrientationEstimate> all = new ArrayList<>();
    LiveOrientation live =
        new LiveOrientation(
            Flights.cameras(scene),
            OrientationSettings.defaults(),
            50_000,
            (now, body) -> all.add(now));
    for (long k = 0; k < 20; k++) {
      live.line(0, line(0, k));
      live.line(1, line(1, k));
    }
    assertEquals(15, all.size());
    live.line(2, line(2, 3));
    assertEquals(1, live.late());
    live.reached(2, scene.pictureTimeUs(19));
    assertEquals(20, all.size());
    live.reset();
    live.line(0, line(0, 0));
    live.line(1, line(1, 0));
    live.line(2, line(2, 0));
    assertEquals(21, all.size());
    assertTrue(all.get(20).timeUs() < all.get(19).timeUs(), "it began anew");
  }
}
