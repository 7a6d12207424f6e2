package haltere.core.simulation.internal.sensor;

/**
 * A smooth random process that can be evaluated at any time in any order: a sum of sinusoids with
 * seeded frequencies and phases. Its mean over time is 0 and its standard deviation over time is
 * exactly the requested one; its values are close to a normal distribution.
 *
 * <p>Thread rule: immutable.
 */
public final class SlowProcess {
  private static final int TERMS = 8;

  private final double[] amplitude = new double[TERMS];
  private final double[] omega = new double[TERMS];
  private final double[] phase = new double[TERMS];
  private final boolean still;

  /**
   * A process.
   *
   * @param random draws the frequencies and phases
   * @param sd standard deviation over time
   * @param slowestHz lower end of its band
   * @param fastestHz upper end of its band
   */
  public SlowProcess(SeededRandom random, double sd, double slowestHz, double fastestHz) {
    still = sd == 0;
    for (int k = 0; k < TERMS; k++) {
      double place = (k + random.nextDouble()) / TERMS;
      amplitude[k] = sd * StrictMath.sqrt(2.0 / TERMS);
      omega[k] = 2 * Math.PI * (slowestHz + (fastestHz - slowestHz) * place);
      phase[k] = random.between(0, 2 * Math.PI);
    }
  }

  /**
   * Its value.
   *
   * @param seconds any time
   * @return in the unit of the standard deviation
   */
  public double at(double seconds) {
    double sum = 0;
    if (!still) {
      for (int k = 0; k < TERMS; k++) {
        sum += amplitude[k] * StrictMath.sin(omega[k] * seconds + phase[k]);
      }
    }
    return sum;
  }

  /**
   * Bound of its values.
   *
   * @return maximum absolute value
   */
  public double bound() {
    return TERMS * amplitude[0];
  }

  /**
   * Its integral from time 0.
   *
   * @param seconds to which time
   * @return in the unit of the standard deviation times seconds
   */
  public double integralTo(double seconds) {
    double sum = 0;
    if (!still) {
      for (int k = 0; k < TERMS; k++) {
        sum +=
            amplitude[k]
                / omega[k]
                * (StrictMath.cos(phase[k]) - StrictMath.cos(omega[k] * seconds + phase[k]));
      }
    }
    return sum;
  }
}
