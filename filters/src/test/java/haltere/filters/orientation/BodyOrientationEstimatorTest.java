package haltere.filters.orientation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.simulation.internal.flight.FlightScene;
import haltere.core.simulation.internal.flight.FlightTruth;
import haltere.filters.orientation.camera.CameraModel;
import haltere.filters.orientation.camera.LineObservation;
import haltere.filters.orientation.camera.Vectors;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class BodyOrientationEstimatorTest {
  private static final OrientationSettings USUAL = OrientationSettings.defaults();

  private static void assertSound(OrientationEstimate now) {
    double[] u = {now.ux(), now.uy(), now.uz()};
    assertEquals(1, Vectors.length(u), 1e-12);
    for (double number :
        new double[] {
          now.xM(),
          now.yM(),
          now.zM(),
          now.sdAxisRad(),
          now.sdRollRad(),
          now.pRadS(),
          now.qRadS(),
          now.rRadS(),
          now.headProbability()
        }) {
      assertTrue(Double.isFinite(number), now.toString());
    }
    assertTrue(now.sdAxisRad() > 0 && now.sdRollRad() > 1.5, now.toString());
  }

  private static List<LineObservation> seen(FlightScene scene, long picture) {
    return Flights.observations(scene, scene.detections(picture));
  }

  private static FlightScene clean(int cameras, long seed) {
    return Flights.scene(cameras, seed, "detection.outlierShare=0", "detection.missingShare=0");
  }

  private static double errorDeg(OrientationEstimate now, FlightTruth truth) {
    return Math.toDegrees(
        Vectors.angle(
            new double[] {now.ux(), now.uy(), now.uz()},
            new double[] {truth.ux(), truth.uy(), truth.uz()}));
  }

  @Test
  void sampledFlightsHaveTheDocumentedErrors() {
    for (int cameras : new int[] {2, 3, 6}) {
      List<Double> axis = new ArrayList<>();
      long wrong = 0;
      long rejected = 0;
      long outliers = 0;
      List<Double> nees = new ArrayList<>();
      for (long seed = 1; seed <= 8; seed++) {
        FlightScores scores = FlightScores.of(Flights.scene(cameras, seed), USUAL, 2);
        axis.addAll(scores.axisDeg);
        nees.addAll(scores.nees);
        wrong += scores.wrongSigns;
        rejected += scores.outliersRejected;
        outliers += scores.outliers;
        assertTrue(scores.worstLength < 1e-12);
        assertEquals(scores.instants, scores.estimates);
      }
      double median = FlightScores.quantile(axis, 0.5);
      assertTrue(median < (cameras == 2 ? 3 : 1.5), cameras + " cameras: " + median);
      assertEquals(0, wrong, cameras + " cameras");
      assertTrue(rejected > 0.95 * outliers, rejected + " of " + outliers);
      double middle = FlightScores.quantile(nees, 0.5);
      assertTrue(middle > 0.7 && middle < 1.8, "median NEES " + middle + ", 1.39 to be expected");
    }
  }

  @Test
  void axisInThePlaneOfBothCamerasKeepsItsHead() {
    // flights in which the axis lies where two cameras tell nothing, most of them with false lines
    for (long seed : new long[] {156, 226, 376, 467, 477, 501, 540}) {
      FlightScores scores = FlightScores.of(Flights.scene(2, seed), USUAL, 3);
      assertTrue(scores.widestRad > Math.toRadians(15), "flight " + seed + " is no doubt");
      assertEquals(0, scores.wrongSigns, "flight " + seed);
    }
  }

  @Test
  void originalFormFollowsAFlight() {
    FlightScores scores = FlightScores.of(Flights.scene(3, 5), OrientationSettings.original(), 2);
    double median = FlightScores.quantile(scores.axisDeg, 0.5);
    assertTrue(median < 8, "median " + median);
    assertTrue(scores.worstLength < 1e-12);
  }

  @Test
  void cameraNoiseIsEstimatedInDegrees() {
    FlightScene scene = Flights.scene(4, 2, "detection.angleSdDeg=4", "body.saccadesPerS=0.3");
    BodyOrientationEstimator body =
        new BodyOrientationEstimator(Flights.cameras(scene), USUAL.with("line.calibrate=true"));
    for (long k = 0; k < 1500; k++) {
      body.update(scene.pictureTimeUs(k), seen(scene, k));
    }
    for (int camera = 0; camera < 4; camera++) {
      assertEquals(4, Math.toDegrees(body.lineSdRad(camera)), 0.9, "camera " + camera);
    }
    assertEquals(0.95, body.meanNis(), 0.25);
  }

  @Test
  void gateOfZeroRejectsAndGateOf180AcceptsAllLines() {
    FlightScene scene = Flights.scene(3, 3);
    for (String form : new String[] {"error-state", "quaternion"}) {
      for (int gate : new int[] {0, 180}) {
        BodyOrientationEstimator body =
            new BodyOrientationEstimator(
                Flights.cameras(scene), USUAL.with("gate.angleDeg=" + gate, "form=" + form));
        int estimates = 0;
        for (long k = 0; k < 100; k++) {
          Optional<OrientationEstimate> now = body.update(scene.pictureTimeUs(k), seen(scene, k));
          now.ifPresent(BodyOrientationEstimatorTest::assertSound);
          estimates += now.isPresent() ? 1 : 0;
          assertEquals(0, now.map(OrientationEstimate::rejected).orElse(0), form + " " + gate);
        }
        long used = body.count(OrientationCount.USED);
        long rejected = body.count(OrientationCount.REJECTED);
        assertEquals(gate == 0 ? 0 : 100, estimates, form + " " + gate);
        assertEquals(0, gate == 0 ? used : rejected, form + " " + gate);
        assertTrue((gate == 0 ? rejected : used) > 200, form + " " + gate);
        assertEquals(gate == 0 ? 100 : 0, body.count(OrientationCount.NO_AXIS));
      }
    }
  }

  @Test
  void smallAndRoundDetectionsAreSkippedAndCounted() {
    FlightScene scene = clean(3, 4);
    BodyOrientationEstimator body =
        new BodyOrientationEstimator(
            Flights.cameras(scene), USUAL.with("gate.minAreaPx=5", "gate.minEccentricity=1.2"));
    for (long k = 0; k < 50; k++) {
      List<LineObservation> seen = new ArrayList<>(seen(scene, k));
      LineObservation first = seen.get(0);
      double area = k % 2 == 0 ? 4 : 50;
      double ratio = k % 2 == 0 ? 3 : 1.1;
      seen.set(
          0,
          new LineObservation(
              first.camera(), first.xPx(), first.yPx(), first.angleRad(), area, ratio));
      Optional<OrientationEstimate> now = body.update(scene.pictureTimeUs(k), seen);
      assertTrue(now.orElseThrow().rejected() >= 1);
    }
    assertEquals(25, body.count(OrientationCount.SMALL));
    assertEquals(25, body.count(OrientationCount.ROUND));
  }

  @Test
  void singleCameraLinesAreCountedWithoutAnOrientation() {
    FlightScene scene = clean(1, 1);
    BodyOrientationEstimator body = new BodyOrientationEstimator(Flights.cameras(scene), USUAL);
    for (long k = 0; k < 20; k++) {
      assertTrue(body.update(scene.pictureTimeUs(k), seen(scene, k)).isEmpty());
    }
    assertEquals(20, body.count(OrientationCount.NO_POSITION));
  }

  @Test
  void camerasCollinearWithTheBodyGiveNoOrientation() {
    List<CameraModel> cameras = new ArrayList<>();
    for (double away : new double[] {1, 2, 3}) {
      double[] matrix = {800, 0, 320, 320 * away, 0, 800, 240, 240 * away, 0, 0, 1, away};
      cameras.add(CameraModel.of("at " + away, matrix, new double[0], 0, 0));
    }
    BodyOrientationEstimator body = new BodyOrientationEstimator(cameras, USUAL);
    for (long k = 0; k < 20; k++) {
      List<LineObservation> seen = new ArrayList<>();
      for (int i = 0; i < 3; i++) {
        seen.add(new LineObservation(i, 320, 240, 0.3, 50, 3));
      }
      assertTrue(body.update(k * 10_000, seen).isEmpty());
    }
    assertEquals(20, body.count(OrientationCount.NO_POSITION));
  }

  @Test
  void unusableCamerasAreSkippedAndOthersContinue() {
    FlightScene scene = clean(3, 6);
    List<CameraModel> cameras = new ArrayList<>(Flights.cameras(scene));
    double[] flat = cameras.get(1).matrix();
    System.arraycopy(flat, 0, flat, 4, 4);
    cameras.set(1, CameraModel.of("flat", flat, new double[0], 0, 0));
    BodyOrientationEstimator body = new BodyOrientationEstimator(cameras, USUAL);
    for (long k = 0; k < 100; k++) {
      assertSound(body.update(scene.pictureTimeUs(k), seen(scene, k)).orElseThrow());
    }
    assertEquals(100, body.count(OrientationCount.UNUSABLE_CAMERA));
  }

  @Test
  void invalidLateAndRepeatedLinesAreCountedAndIgnored() {
    FlightScene scene = clean(3, 7);
    BodyOrientationEstimator body = new BodyOrientationEstimator(Flights.cameras(scene), USUAL);
    BodyOrientationEstimator plain = new BodyOrientationEstimator(Flights.cameras(scene), USUAL);
    for (long k = 0; k < 50; k++) {
      List<LineObservation> good = seen(scene, k);
      List<LineObservation> more = new ArrayList<>(good);
      more.add(new LineObservation(0, 1, 1, 1, 1, 1));
      Optional<OrientationEstimate> expected = plain.update(scene.pictureTimeUs(k), good);
      assertEquals(expected, body.update(scene.pictureTimeUs(k), more));
      assertTrue(body.update(scene.pictureTimeUs(k) - 1, good).isEmpty());
    }
    assertEquals(50, body.count(OrientationCount.DUPLICATE));
    assertEquals(150, body.count(OrientationCount.OUT_OF_ORDER));
    List<LineObservation> nothing =
        List.of(
            new LineObservation(0, Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN),
            new LineObservation(1, 100, Double.POSITIVE_INFINITY, Double.NaN, 1, 1));
    assertSound(body.update(scene.pictureTimeUs(51), nothing).orElseThrow());
    assertEquals(2, body.count(OrientationCount.WITHOUT_ANGLE));
  }

  @Test
  void passingThroughACameraCentreLeavesNoNaN() {
    FlightScene scene = clean(3, 8);
    List<CameraModel> cameras = Flights.cameras(scene);
    double[] centre = cameras.get(0).centre();
    for (OrientationSettings settings :
        List.of(USUAL, OrientationSettings.original(), USUAL.with("form=quaternion"))) {
      BodyOrientationEstimator body = new BodyOrientationEstimator(cameras, settings);
      double[] pixel = new double[2];
      for (int k = 0; k <= 100; k++) {
        double way = (k - 50) * 0.002;
        double[] at = {centre[0] + way, centre[1], centre[2]};
        List<LineObservation> seen = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
          if (cameras.get(i).project(at, pixel)) {
            seen.add(
                new LineObservation(
                    i,
                    pixel[0],
                    pixel[1],
                    cameras.get(i).heading(at, new double[] {0.6, 0.8, 0}),
                    10,
                    3));
          }
        }
        body.update(k * 10_000L, seen).ifPresent(BodyOrientationEstimatorTest::assertSound);
      }
      assertTrue(body.count(OrientationCount.USED) > 100);
    }
  }

  @Test
  void asynchronousCamerasInitialiseABodyTogether() {
    FlightScene scene =
        Flights.scene(
            2, 9, "detection.outlierShare=0", "detection.missingShare=0", "detection.rateHz=400");
    BodyOrientationEstimator body = new BodyOrientationEstimator(Flights.cameras(scene), USUAL);
    List<Double> errors = new ArrayList<>();
    for (long k = 0; k < 800; k++) {
      List<LineObservation> both = seen(scene, k);
      Optional<OrientationEstimate> now =
          body.update(scene.pictureTimeUs(k), List.of(both.get((int) (k % 2))));
      if (k > 100) {
        errors.add(errorDeg(now.orElseThrow(), scene.truthAt(scene.pictureTimeUs(k))));
      }
    }
    assertTrue(FlightScores.quantile(errors, 0.5) < 2.5);
  }

  @Test
  void bodiesRestartAfterALongAbsence() {
    FlightScene scene = clean(3, 10);
    BodyOrientationEstimator body = new BodyOrientationEstimator(Flights.cameras(scene), USUAL);
    body.update(scene.pictureTimeUs(0), seen(scene, 0));
    body.update(scene.pictureTimeUs(1), seen(scene, 1));
    assertFalse(body.update(scene.pictureTimeUs(400), List.of()).isPresent());
    OrientationEstimate now = body.update(scene.pictureTimeUs(401), seen(scene, 401)).orElseThrow();
    double error = errorDeg(now, scene.truthAt(scene.pictureTimeUs(401)));
    assertTrue(Math.min(error, 180 - error) < 10, "error " + error);
  }
}
