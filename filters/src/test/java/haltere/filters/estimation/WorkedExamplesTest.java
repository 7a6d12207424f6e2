package haltere.filters.estimation;

import static haltere.filters.estimation.WorkedExamples.DAMPING;
import static haltere.filters.estimation.WorkedExamples.FREQUENCY;
import static haltere.filters.estimation.WorkedExamples.GRAVITY;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.WorkedExamples.Spring;
import haltere.filters.estimation.motion.DampedOscillator;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What docs/estimation.md says of its two examples. */
class WorkedExamplesTest {
  private static final int RUNS = 100;

  private static Estimate last(List<Estimate> estimates) {
    return estimates.get(estimates.size() - 1);
  }

  @Test
  void aFallOfFourTenthsOfASecondGivesGravity() {
    Estimate end = last(WorkedExamples.fallingWeight(WorkedExamples.SHOWN_FALL));
    double deviation = end.standardDeviation(2);
    assertTrue(deviation <= 0.1, "standard deviation " + deviation + " m/s²");
    assertEquals(GRAVITY, end.value(2), deviation, "within one standard deviation");
    assertEquals(0.4, end.timeS(), 0.001);
  }

  @Test
  void overAHundredFallsGravityIsFoundAsOftenWithinOneDeviationAsItShould() {
    int within = 0;
    double sum = 0;
    double nees = 0;
    double deviation = 0;
    for (int seed = 0; seed < RUNS; seed++) {
      Estimate end = last(WorkedExamples.fallingWeight(seed));
      deviation = end.standardDeviation(2);
      within += Math.abs(end.value(2) - GRAVITY) <= deviation ? 1 : 0;
      sum += end.value(2);
      nees += Consistency.nees(end, WorkedExamples.fallingWeightTruth(seed)) / RUNS;
    }
    double share = 0.6827;
    assertEquals(share, within / (double) RUNS, 3 * Math.sqrt(share * (1 - share) / RUNS));
    assertEquals(GRAVITY, sum / RUNS, 3 * deviation / Math.sqrt(RUNS), "without bias");
    Interval band = Consistency.meanBand(3, RUNS, 0.95);
    assertTrue(band.contains(nees), "NEES " + nees + " in " + band);
  }

  @ParameterizedTest
  @ValueSource(doubles = {3, FREQUENCY / 3, FREQUENCY * 3})
  void anOscillatorIsFoundFromAFrequencyWrongByThree(double start) {
    double nees = 0;
    for (int seed = 0; seed < RUNS; seed++) {
      Spring spring = new Spring(seed);
      Estimate end = last(spring.secondPass(spring.firstPass(start)));
      assertEquals(1, end.value(DampedOscillator.FREQUENCY) / FREQUENCY, 0.005, "ω of " + seed);
      assertEquals(1, end.value(DampedOscillator.DAMPING) / DAMPING, 0.05, "ζ of " + seed);
      nees += Consistency.nees(end, spring.truth) / RUNS;
    }
    Interval band = Consistency.meanBand(4, RUNS, 0.95);
    assertTrue(band.contains(nees), "NEES " + nees + " in " + band);
  }

  @Test
  void fromTheReportsOwnStartItsResultsAreReached() {
    double[] afterASecond = new double[RUNS];
    for (int seed = 0; seed < RUNS; seed++) {
      List<Estimate> pass = new Spring(seed).firstPass(3);
      afterASecond[seed] = pass.get(240).standardDeviation(DampedOscillator.FREQUENCY);
      Estimate end = last(pass);
      assertEquals(1, end.value(DampedOscillator.FREQUENCY) / FREQUENCY, 0.005, "ω of " + seed);
      assertEquals(1, end.value(DampedOscillator.DAMPING) / DAMPING, 0.05, "ζ of " + seed);
    }
    Arrays.sort(afterASecond);
    assertEquals(1, afterASecond[RUNS / 2], 0.1, "standard deviation of ω after 1 s, median");
  }

  @Test
  void believedAsTheyDeserveMeasurementsLeadAstrayFromThatStart() {
    int found = 0;
    for (int seed = 0; seed < RUNS; seed++) {
      try {
        Estimate end = last(new Spring(seed).onlyPass());
        double ratio = Math.abs(end.value(DampedOscillator.FREQUENCY)) / FREQUENCY;
        found += Math.abs(ratio - 1) < 0.02 ? 1 : 0;
      } catch (ArithmeticException leftTheNumbers) {
        // Not found either.
      }
    }
    assertTrue(found < RUNS / 2, "found " + found);
  }
}
