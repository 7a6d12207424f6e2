package haltere.filters.estimation.motion;

import haltere.filters.estimation.Require;
import java.util.Objects;
import java.util.function.BiConsumer;

/**
 * The classical Runge-Kutta method of fourth order: Kutta (1901); Press et al., "Numerical
 * Recipes", eq. 16.1.3. The error of a step is of fifth order in its length.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 */
public final class RungeKutta4 {
  private final BiConsumer<double[], double[]> derivative;
  private final double[] k1;
  private final double[] k2;
  private final double[] k3;
  private final double[] k4;
  private final double[] between;

  /**
   * An integrator of one equation.
   *
   * @param size dimension of the state
   * @param derivative right-hand side f of dx/dt = f(x): gets x, not to be changed, and fills dx/dt
   */
  public RungeKutta4(int size, BiConsumer<double[], double[]> derivative) {
    this.derivative = Objects.requireNonNull(derivative, "derivative");
    k1 = new double[size];
    k2 = new double[size];
    k3 = new double[size];
    k4 = new double[size];
    between = new double[size];
  }

  /**
   * Integrates in equal steps.
   *
   * @param x state, replaced by that at the end
   * @param dtS seconds in all
   * @param steps their number, at least 1
   */
  public void integrate(double[] x, double dtS, int steps) {
    double h = dtS / Require.atLeast("steps", 1, steps);
    for (int i = 0; i < steps; i++) {
      step(x, h);
    }
  }

  private void step(double[] x, double h) {
    derivative.accept(x, k1);
    derivative.accept(along(x, 0.5 * h, k1), k2);
    derivative.accept(along(x, 0.5 * h, k2), k3);
    derivative.accept(along(x, h, k3), k4);
    for (int i = 0; i < x.length; i++) {
      x[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    }
  }

  private double[] along(double[] x, double h, double[] slope) {
    for (int i = 0; i < x.length; i++) {
      between[i] = x[i] + h * slope[i];
    }
    return between;
  }
}
