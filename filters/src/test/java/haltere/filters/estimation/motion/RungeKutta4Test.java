package haltere.filters.estimation.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.Oscillations;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The comparison of integrators in the report that the worked examples come from. */
class RungeKutta4Test {
  private static final double OMEGA = 2 * Math.PI * 3;
  private static final double ZETA = 0.1;
  private static final double SPAN_S = 0.1;

  private final RungeKutta4 rungeKutta =
      new RungeKutta4(
          2,
          (x, dx) -> {
            dx[0] = x[1];
            dx[1] = -OMEGA * OMEGA * x[0] - 2 * ZETA * OMEGA * x[1];
          });

  /** How many steps depends on where the motion starts, so the start is part of the statement. */
  @ParameterizedTest
  @CsvSource({"0, 1, 425", "1, 0, 2134"})
  void theFirstOrderSchemeNeedsManyMoreStepsThanThree(double s0, double v0, int steps) {
    double threeSteps = errorOfRungeKutta(s0, v0, 3);
    assertTrue(errorOfEuler(s0, v0, steps) <= threeSteps, "as near with " + steps + " steps");
    assertTrue(errorOfEuler(s0, v0, steps - 1) > threeSteps, "but not with one less");
  }

  @Test
  void halfTheStepGivesASixteenthOfTheError() {
    double ratio = errorOfRungeKutta(1, 0, 40) / errorOfRungeKutta(1, 0, 80);
    assertEquals(16, ratio, 0.5);
  }

  @Test
  void noStepsAreRefused() {
    assertThrows(
        IllegalArgumentException.class, () -> rungeKutta.integrate(new double[2], SPAN_S, 0));
  }

  private double errorOfRungeKutta(double s0, double v0, int steps) {
    double[] x = {s0, v0};
    rungeKutta.integrate(x, SPAN_S, steps);
    return distance(x, s0, v0);
  }

  private static double errorOfEuler(double s0, double v0, int steps) {
    double s = s0;
    double v = v0;
    double h = SPAN_S / steps;
    for (int i = 0; i < steps; i++) {
      double a = -OMEGA * OMEGA * s - 2 * ZETA * OMEGA * v;
      s += h * v;
      v += h * a;
    }
    return distance(new double[] {s, v}, s0, v0);
  }

  private static double distance(double[] x, double s0, double v0) {
    double[] exact = Oscillations.exact(s0, v0, ZETA, OMEGA, SPAN_S);
    return Math.hypot(x[0] - exact[0], x[1] - exact[1]);
  }
}
