package haltere.filters.estimation.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.internal.example.Oscillations;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The comparison of integrators by Casper (2012). */
class RungeKutta4Test {
  /** How many steps depends on where the motion starts, so the start is part of the statement. */
  @ParameterizedTest
  @CsvSource({"0, 1, 425", "1, 0, 2134"})
  void firstOrderSchemeNeedsManyMoreSteps(double s0, double v0, int steps) {
    double threeSteps = Oscillations.error(false, s0, v0, 3);
    assertTrue(
        Oscillations.error(true, s0, v0, steps) <= threeSteps, "as near with " + steps + " steps");
    assertTrue(Oscillations.error(true, s0, v0, steps - 1) > threeSteps, "but not with one less");
  }

  @Test
  void halvingTheStepGivesASixteenthOfTheError() {
    double ratio = Oscillations.error(false, 1, 0, 40) / Oscillations.error(false, 1, 0, 80);
    assertEquals(16, ratio, 0.5);
  }

  @Test
  void zeroStepsAreRejected() {
    assertThrows(IllegalArgumentException.class, () -> Oscillations.error(false, 1, 0, 0));
  }
}
