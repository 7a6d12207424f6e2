package haltere.filters.estimation;

/** Exact motion of the under-damped oscillator, for the tests to compare with. */
public final class Oscillations {
  private Oscillations() {}

  /** Displacement and velocity after a time; Landau and Lifshitz, "Mechanics", eq. 25.3. */
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
}
