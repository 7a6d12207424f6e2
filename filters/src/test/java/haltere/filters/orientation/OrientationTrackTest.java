package haltere.filters.orientation;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.simulation.internal.flight.FlightScene;
import haltere.filters.orientation.camera.LineObservation;
import haltere.filters.orientation.camera.RandomCameras;
import haltere.filters.orientation.camera.Vectors;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class OrientationTrackTest {
  private static FlightScores[] scores(FlightScene scene, OrientationSettings settings) {
    OrientationTrack track = new OrientationTrack(Flights.cameras(scene), settings);
    FlightScores online = new FlightScores();
    FlightScores smoothed = new FlightScores();
    for (long k = 0; k < 200; k++) {
      track
          .update(scene.pictureTimeUs(k), Flights.observations(scene, scene.detections(k)))
          .ifPresent(now -> online.note(now, scene.truthAt(now.timeUs()), true));
    }
    for (OrientationEstimate now : track.smoothed()) {
      smoothed.note(now, scene.truthAt(now.timeUs()), true);
    }
    return new FlightScores[] {online, smoothed};
  }

  @Test
  void smoothingImprovesAxesAndPositionsAndResolvesAllSigns() {
    List<Double> online = new ArrayList<>();
    List<Double> smoothed = new ArrayList<>();
    List<Double> positions = new ArrayList<>();
    List<Double> placesSmoothed = new ArrayList<>();
    for (long seed = 1; seed <= 5; seed++) {
      FlightScores[] both = scores(Flights.scene(3, seed), OrientationSettings.defaults());
      assertEquals(both[0].estimates, both[1].estimates);
      assertEquals(0, both[1].wrongSigns, "seed " + seed);
      assertTrue(both[1].worstLength < 1e-12);
      online.addAll(both[0].lineDeg);
      smoothed.addAll(both[1].lineDeg);
      positions.addAll(both[0].placeMm);
      placesSmoothed.addAll(both[1].placeMm);
    }
    double before = FlightScores.quantile(online, 0.5);
    double after = FlightScores.quantile(smoothed, 0.5);
    assertTrue(after < 0.85 * before, before + " to " + after + " deg");
    assertTrue(
        FlightScores.quantile(placesSmoothed, 0.5) < 0.8 * FlightScores.quantile(positions, 0.5));
  }

  @Test
  void originalSmootherYieldsUnitVectorsNearTheAxis() {
    FlightScores[] both = scores(Flights.scene(4, 6), OrientationSettings.original());
    assertTrue(both[1].worstLength < 1e-12);
    assertTrue(FlightScores.quantile(both[1].lineDeg, 0.5) < 12);
  }

  @Test
  void simultaneousUpdatesAndEmptyTracksAreSmoothed() {
    FlightScene scene = Flights.scene(3, 8);
    for (OrientationSettings settings :
        List.of(OrientationSettings.defaults(), OrientationSettings.original())) {
      OrientationTrack track = new OrientationTrack(Flights.cameras(scene), settings);
      assertEquals(List.of(), track.smoothed());
      for (long k = 0; k < 40; k++) {
        List<LineObservation> seen = Flights.observations(scene, scene.detections(k));
        track.update(scene.pictureTimeUs(k), seen);
        track.update(scene.pictureTimeUs(k), seen.subList(0, 1));
      }
      List<OrientationEstimate> smoothed = track.smoothed();
      assertTrue(smoothed.size() > 70, smoothed.size() + " estimates");
      assertEquals(smoothed.get(20).timeUs(), smoothed.get(21).timeUs());
    }
  }

  @Test
  void signPathHasMinimalCost() {
    SplittableRandom random = new SplittableRandom(1);
    for (int round = 0; round < 50; round++) {
      int count = 8;
      List<double[]> axes = new ArrayList<>();
      List<double[]> velocities = new ArrayList<>();
      double[] weights = new double[count];
      boolean[] linked = new boolean[count];
      for (int t = 0; t < count; t++) {
        axes.add(RandomCameras.unit(random));
        velocities.add(t == 3 ? new double[3] : RandomCameras.unit(random));
        weights[t] = random.nextDouble(0.9);
        linked[t] = t != 5;
      }
      boolean[] found = DirectionChoice.flips(axes, velocities, weights, linked);
      double best = Double.POSITIVE_INFINITY;
      boolean[] cheapest = null;
      for (int code = 0; code < 1 << count; code++) {
        boolean[] flips = new boolean[count];
        for (int t = 0; t < count; t++) {
          flips[t] = (code >> t & 1) == 1;
        }
        double cost = cost(axes, velocities, weights, linked, flips);
        if (cost < best - 1e-12) {
          best = cost;
          cheapest = flips;
        }
      }
      assertEquals(best, cost(axes, velocities, weights, linked, found), 1e-9);
      assertArrayEquals(cheapest, found, "round " + round);
    }
  }

  private static double cost(
      List<double[]> axes,
      List<double[]> velocities,
      double[] weights,
      boolean[] linked,
      boolean[] flips) {
    double sum = 0;
    for (int t = 0; t < flips.length; t++) {
      double[] u = signed(axes.get(t), flips[t]);
      double[] v = velocities.get(t);
      double w = weights[t];
      sum += (1 - w) * Math.acos(u[2]);
      if (Vectors.length(v) > 0) {
        double level = Math.hypot(v[0], v[1]);
        double elevation = Math.min(Math.PI / 2, Math.atan2(v[2], level) + Math.PI / 4);
        double[] tipped = {
          Math.cos(elevation) * v[0] / level,
          Math.cos(elevation) * v[1] / level,
          Math.sin(elevation)
        };
        sum += w * Math.acos(Vectors.dot(u, tipped));
      }
      if (t > 0 && linked[t]) {
        sum += (1 - w) * Math.acos(Vectors.dot(u, signed(axes.get(t - 1), flips[t - 1])));
      }
    }
    return sum;
  }

  private static double[] signed(double[] u, boolean flip) {
    double sign = flip ? -1 : 1;
    return new double[] {sign * u[0], sign * u[1], sign * u[2]};
  }

  @Test
  void originalPresetWeightsSpeedInMetresPerSecond() {
    assertEquals(0.15, DirectionChoice.originalWeight(0.3), 1e-12);
    assertEquals(0.9, DirectionChoice.originalWeight(5), 1e-12);
    assertEquals(0.45, DirectionChoice.weightOf(0.003, 0.001), 1e-12);
  }
}
