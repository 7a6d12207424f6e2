package haltere.filters.estimation.internal.example;

import static haltere.filters.estimation.internal.example.SimulatedVideo.DAMPING;
import static haltere.filters.estimation.internal.example.SimulatedVideo.FREQUENCY_RAD_S;
import static haltere.filters.estimation.internal.example.SimulatedVideo.GRAVITY_M_S2;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.simulation.internal.sensor.SeededRandom;
import haltere.filters.estimation.Consistency;
import haltere.filters.estimation.Estimate;
import haltere.filters.estimation.Interval;
import haltere.filters.estimation.motion.DampedOscillator;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Statements of docs/estimation.md about its two examples. */
class WorkedExamplesTest {
  private static final int RUNS = 100;

  /** Half the width of the 95 % interval of a normal distribution, in standard deviations. */
  private static final double SIGMAS_95 = 1.96;

  /** Seed of the fall that the documentation shows; one in three ends outside one deviation. */
  private static final long SHOWN_FALL = 1;

  private static Estimate last(List<Estimate> estimates) {
    return estimates.get(estimates.size() - 1);
  }

  @Test
  void fallOf400MsYieldsGravity() {
    Estimate end = last(new FallingWeight(SimulatedVideo.fallingWeight(SHOWN_FALL)).estimates());
    double deviation = end.standardDeviation(2);
    assertTrue(deviation <= 0.1, "standard deviation " + deviation + " m/s²");
    assertEquals(GRAVITY_M_S2, end.value(2), deviation);
    assertEquals(0.4, end.timeS(), 0.001);
  }

  @Test
  void gravityOfAHundredFallsIsConsistent() {
    int within = 0;
    double sum = 0;
    double nees = 0;
    double deviation = 0;
    for (int seed = 0; seed < RUNS; seed++) {
      Estimate end = last(new FallingWeight(SimulatedVideo.fallingWeight(seed)).estimates());
      deviation = end.standardDeviation(2);
      within += Math.abs(end.value(2) - GRAVITY_M_S2) <= deviation ? 1 : 0;
      sum += end.value(2);
      double t = end.timeS();
      double v0 = SimulatedVideo.fallingWeightVelocity(seed);
      nees +=
          Consistency.nees(
                  end, v0 * t + GRAVITY_M_S2 * t * t / 2, v0 + GRAVITY_M_S2 * t, GRAVITY_M_S2)
              / RUNS;
    }
    double share = 0.6827;
    assertEquals(share, within / (double) RUNS, 3 * Math.sqrt(share * (1 - share) / RUNS));
    assertEquals(GRAVITY_M_S2, sum / RUNS, 3 * deviation / Math.sqrt(RUNS), "without bias");
    Interval band = Consistency.meanBand(3, RUNS, 0.95);
    assertTrue(band.contains(nees), "NEES " + nees + " in " + band);
  }

  @Test
  void filterParabolaAndSmootherAgreeAtTheEndOfAFall() {
    ExampleTable table = new FallingWeight(SimulatedVideo.fallingWeight(SHOWN_FALL)).table();
    double a = end(table, "a_m_s2");
    double deviation = end(table, "sd_a_m_s2");
    assertEquals(a, end(table, "smoothed_a_m_s2"), 1e-9);
    assertEquals(a, end(table, "fit_a_m_s2"), 0.3 * deviation);
    assertEquals(deviation, end(table, "sd_fit_a_m_s2"), 0.1 * deviation);
    double[] measured = table.column("x_m");
    double[] fit = table.column("fit_s_m");
    for (int k = 0; k < measured.length; k++) {
      assertEquals(measured[k], fit[k], 0.02);
    }
  }

  private static double end(ExampleTable table, String column) {
    double[] values = table.column(column);
    return values[values.length - 1];
  }

  private static MeasurementSeries pushed(long seed) {
    return SimulatedVideo.oscillator(seed, 0, pushMS(seed));
  }

  private static double pushMS(long seed) {
    return 0.6 + 0.1 * new SeededRandom(seed, "push").gaussian();
  }

  /** True (s, v, ζ, ω) at the time of an estimate. */
  private static double[] truth(boolean released, long seed, double timeS) {
    double s0 = released ? SimulatedVideo.releaseM(seed) : 0;
    double v0 = released ? 0 : pushMS(seed);
    double[] at = Oscillations.exact(s0, v0, DAMPING, FREQUENCY_RAD_S, timeS);
    return new double[] {at[0], at[1], DAMPING, FREQUENCY_RAD_S};
  }

  /** Estimates of runs 0 to 99 at some measurements and at the last. */
  private static Estimate[][] runs(boolean released, double startRadS, int... at) {
    return IntStream.range(0, RUNS)
        .parallel()
        .mapToObj(seed -> released ? SimulatedVideo.oscillator(seed) : pushed(seed))
        .map(series -> new Oscillator(series, startRadS).estimates())
        .map(all -> Arrays.stream(at).mapToObj(all::get).toArray(Estimate[]::new))
        .toArray(Estimate[][]::new);
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void releasedAndPushedOscillatorsAreIdentifiedWithinDeviations(boolean released) {
    int[] at = {240, 480, 1201};
    Estimate[][] runs = runs(released, Oscillator.START_FREQUENCY_RAD_S, at);
    int dampingWithin = 0;
    int frequencyWithin = 0;
    double[] nees = new double[at.length];
    for (int seed = 0; seed < RUNS; seed++) {
      Estimate end = runs[seed][at.length - 1];
      dampingWithin += isWithin(end, DampedOscillator.DAMPING, DAMPING) ? 1 : 0;
      frequencyWithin += isWithin(end, DampedOscillator.FREQUENCY, FREQUENCY_RAD_S) ? 1 : 0;
      for (int i = 0; i < at.length; i++) {
        Estimate now = runs[seed][i];
        nees[i] += Consistency.nees(now, truth(released, seed, now.timeS())) / RUNS;
      }
      assertTrue(end.standardDeviation(DampedOscillator.FREQUENCY) < 0.001, "rad/s");
    }
    assertTrue(dampingWithin >= 90, dampingWithin + " of 100 dampings");
    assertTrue(frequencyWithin >= 90, frequencyWithin + " of 100 frequencies");
    Interval band = Consistency.meanBand(4, RUNS, 0.95);
    for (int i = 0; i < at.length; i++) {
      assertTrue(band.contains(nees[i]), "NEES " + nees[i] + " at " + at[i] + " in " + band);
    }
  }

  private static boolean isWithin(Estimate estimate, int entry, double truth) {
    return Math.abs(estimate.value(entry) - truth) <= SIGMAS_95 * estimate.standardDeviation(entry);
  }

  @ParameterizedTest
  @CsvSource({"false, 1", "false, 0.3333", "false, 3", "true, 0.3333", "true, 3"})
  void oscillatorIsIdentifiedFromAnInitialFrequencyWrongByThree(boolean released, double factor) {
    double nees = 0;
    Estimate[][] runs = runs(released, factor * FREQUENCY_RAD_S, 1201);
    for (int seed = 0; seed < RUNS; seed++) {
      Estimate end = runs[seed][0];
      assertEquals(1, end.value(DampedOscillator.FREQUENCY) / FREQUENCY_RAD_S, 0.005, "" + seed);
      assertEquals(1, end.value(DampedOscillator.DAMPING) / DAMPING, 0.05, "ζ of " + seed);
      nees += Consistency.nees(end, truth(released, seed, end.timeS())) / RUNS;
    }
    Interval band = Consistency.meanBand(4, RUNS, 0.95);
    assertTrue(band.contains(nees), "NEES " + nees + " in " + band);
  }

  @Test
  void resultsOfCasperAreReproducedFromHisInitialState() {
    double[] afterASecond = new double[RUNS];
    for (int seed = 0; seed < RUNS; seed++) {
      List<Estimate> pass = new Oscillator(pushed(seed)).plainFilter(0.27);
      afterASecond[seed] = pass.get(240).standardDeviation(DampedOscillator.FREQUENCY);
      Estimate end = last(pass);
      assertEquals(1, end.value(DampedOscillator.FREQUENCY) / FREQUENCY_RAD_S, 0.005, "" + seed);
      assertEquals(1, end.value(DampedOscillator.DAMPING) / DAMPING, 0.05, "ζ of " + seed);
    }
    Arrays.sort(afterASecond);
    assertEquals(1, afterASecond[RUNS / 2], 0.1, "standard deviation of ω after 1 s, median");
  }

  @Test
  void extendedFilterDivergesFromThisInitialStateWithTheTrueNoise() {
    int found = 0;
    int within = 0;
    for (int seed = 0; seed < RUNS; seed++) {
      found += Math.abs(plainFrequency(pushed(seed)) / FREQUENCY_RAD_S - 1) < 0.02 ? 1 : 0;
      MeasurementSeries released = SimulatedVideo.oscillator(seed);
      List<Estimate> plain = new Oscillator(released).plainFilter(released.noiseM());
      within +=
          plain.size() == released.size()
                  && isWithin(last(plain), DampedOscillator.FREQUENCY, FREQUENCY_RAD_S)
              ? 1
              : 0;
    }
    assertTrue(found < RUNS / 2, "found " + found);
    assertTrue(within < RUNS / 10, "within its deviation " + within);
  }

  private static double plainFrequency(MeasurementSeries series) {
    List<Estimate> plain = new Oscillator(series).plainFilter(series.noiseM());
    return plain.size() == series.size()
        ? Math.abs(last(plain).value(DampedOscillator.FREQUENCY))
        : 0;
  }
}
