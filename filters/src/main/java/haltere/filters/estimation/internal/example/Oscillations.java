package haltere.filters.estimation.internal.example;

import haltere.filters.estimation.motion.RungeKutta4;

/** The exact motion of an under-damped oscillator, and the errors of two integrators. */
public final class Oscillations {
  private static final double OMEGA = 2 * Math.PI * 3;
  private static final double ZETA = 0.1;
  private static final double SPAN_S = 0.1;

  private Oscillations() {}

  /**
   * Displacement and velocity after a time; Landau and Lifshitz, "Mechanics", eq. 25.3.
   *
   * @param s0 displacement at time 0
   * @param v0 velocity at time 0, in units of s0 per second
   * @param zeta damping ratio, −1 to 1, both excluded
   * @param omega undamped angular frequency, rad/s
   * @param timeS seconds
   * @return displacement and velocity
   */
  public static double[] exact(double s0, double v0, double zeta, double omega, double timeS) {
    double damped = omega * Math.sqrt(1 - zeta * zeta);
    double decay = Math.exp(-zeta * omega * timeS);
    double c = Math.cos(damped * timeS);
    double s = Math.sin(damped * timeS);
    double b = (v0 + zeta * omega * s0) / damped;
    return new double[] {
      decay * (s0 * c + b * s),
      decay * ((b * damped - zeta * omega * s0) * c - (s0 * damped + zeta * omega * b) * s)
    };
  }

  /**
   * Error of Runge-Kutta 4, or of the first-order scheme of Euler, after 100 ms of a motion with 3
   * Hz and ζ = 0.1, as in Casper (2012).
   *
   * @param euler true for Euler
   * @param s0 displacement at time 0
   * @param v0 velocity at time 0
   * @param steps their number, at least 1
   * @return distance from the exact (s, v)
   */
  public static double error(boolean euler, double s0, double v0, int steps) {
    double[] x = {s0, v0};
    if (euler) {
      double[] dx = new double[2];
      for (int i = 0; i < steps; i++) {
        derivative(x, dx);
        x[0] += SPAN_S / steps * dx[0];
        x[1] += SPAN_S / steps * dx[1];
      }
    } else {
      new RungeKutta4(2, Oscillations::derivative).integrate(x, SPAN_S, steps);
    }
    double[] exact = exact(s0, v0, ZETA, OMEGA, SPAN_S);
    return Math.hypot(x[0] - exact[0], x[1] - exact[1]);
  }

  private static void derivative(double[] x, double[] dx) {
    dx[0] = x[1];
    dx[1] = -OMEGA * OMEGA * x[0] - 2 * ZETA * OMEGA * x[1];
  }
}
