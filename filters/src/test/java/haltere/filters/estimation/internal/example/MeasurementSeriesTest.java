package haltere.filters.estimation.internal.example;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.simulation.internal.sensor.SeededRandom;
import haltere.filters.estimation.Estimate;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

class MeasurementSeriesTest {
  private static MeasurementSeries series(
      int size, double noise, DoubleUnaryOperator x, DoubleUnaryOperator a) {
    SeededRandom random = new SeededRandom(1, "test");
    List<Measurement> measurements = new ArrayList<>();
    double t = 3;
    for (int k = 0; k < size; k++) {
      t += random.between(0.002, 0.006);
      measurements.add(
          new Measurement(
              t,
              x.applyAsDouble(t) + noise * random.gaussian(),
              a.applyAsDouble(t) + 0.5 * random.gaussian()));
    }
    return new MeasurementSeries(measurements);
  }

  private static MeasurementSeries fall(int size, double noise, boolean withAcceleration) {
    return series(size, noise, t -> 5 - t * t, t -> withAcceleration ? -2 : Double.NaN);
  }

  @Test
  void noiseEstimateDoesNotDependOnTimesAndAcceleration() {
    assertEquals(0.003, fall(2000, 0.003, false).noiseM(), 0.0002);
    assertTrue(fall(2000, 0, false).noiseM() < 1e-5);
  }

  @Test
  void quantisationCountsAsNoise() {
    MeasurementSeries rows = series(400, 0, t -> Math.rint(t * 300) / 100, t -> Double.NaN);
    assertEquals(0.01 / Math.sqrt(12), rows.noiseM(), 0.0005);
    MeasurementSeries slow = series(400, 0, t -> Math.rint(t * 2) / 100, t -> Double.NaN);
    assertEquals(0.01 / Math.sqrt(12), slow.noiseM(), 1e-9);
  }

  @Test
  void finiteDifferencesOfAParabolaAreExactInsideAndUnknownAtTheEnds() {
    MeasurementSeries fall = fall(50, 0, false);
    for (int k = 1; k < 49; k++) {
      assertEquals(-2 * fall.get(k).tS(), fall.velocity(k), 1e-9);
      assertEquals(-2, fall.acceleration(k), 1e-6);
    }
    assertTrue(Double.isNaN(fall.velocity(0)) && Double.isNaN(fall.acceleration(49)));
  }

  @Test
  void measuredAccelerationsReduceTheDeviations() {
    double alone = end(new FallingWeight(fall(100, 0.004, false)).estimates(), 2, -2);
    assertTrue(end(new FallingWeight(fall(100, 0.004, true)).estimates(), 2, -2) < 0.8 * alone);
    DoubleUnaryOperator x = t -> 0.1 * Math.cos(5 * (t - 3));
    double position = end(new Oscillator(series(200, 0.004, x, t -> Double.NaN)).estimates(), 3, 5);
    double both =
        end(new Oscillator(series(200, 0.004, x, t -> -25 * x.applyAsDouble(t))).estimates(), 3, 5);
    assertTrue(both < 0.9 * position, both + " of " + position);
  }

  /** Standard deviation of an entry of the last estimate, which is near the truth. */
  private static double end(List<Estimate> estimates, int entry, double truth) {
    Estimate end = estimates.get(estimates.size() - 1);
    assertEquals(truth, end.value(entry), 4 * end.standardDeviation(entry));
    return end.standardDeviation(entry);
  }

  @Test
  void uninformativeSeriesAreRejected() {
    assertThrows(IllegalArgumentException.class, () -> fall(7, 0.004, false));
    assertThrows(IllegalArgumentException.class, () -> series(20, 0, t -> 1, t -> Double.NaN));
    List<Measurement> back = new ArrayList<>();
    for (int k = 0; k < 20; k++) {
      back.add(new Measurement(k % 19, k * k % 7, Double.NaN));
    }
    assertThrows(IllegalArgumentException.class, () -> new MeasurementSeries(back));
  }
}
