package haltere.filters.wing;

/**
 * Notices a manoeuvre: the phase runs away from what is expected by more than noise explains. The
 * frequency's process noise is then raised, by as much as the phase is off, and falls back slowly,
 * because a manoeuvre that has begun goes on.
 *
 * <p>Thread rule: one thread at a time.
 */
final class RunAway {
  /** Density of the frequency's noise for each squared radian by which the phase runs away. */
  private static final double DENSITY = 4e8;

  /** Events of one beat repeat each other's errors: so many of them count for one. */
  private static final double REPEATING = 3;

  /** A phase is off if its square is so many times its variance. */
  private static final double CLEARLY = 1.5;

  private static final double HOLD_S = 0.03;
  private static final double LEAST_DENSITY = 1;

  private double y;
  private double w;
  private double density;

  void launch() {
    y = 0;
    w = 0;
    density = 0;
  }

  /**
   * Takes a residual.
   *
   * @param residual radians
   * @param weight one over its variance, times the slope
   * @param slope derivative of the angle with respect to the phase
   */
  void add(double residual, double weight, double slope) {
    y += weight * residual;
    w += weight * slope;
  }

  /**
   * Looks, about once in a millisecond; the residuals of the last beat count.
   *
   * @param dtS since the last time
   * @param omega angular frequency
   * @param most largest density
   */
  void look(double dtS, double omega, double most) {
    if (w > 0) {
      double off = y / w;
      double excess = off * off - CLEARLY * REPEATING / w;
      density =
          Math.max(
              density * Math.exp(-dtS / HOLD_S), Math.min(most, excess > 0 ? DENSITY * excess : 0));
      if (density < LEAST_DENSITY) {
        density = 0;
      }
    }
    double fade = Math.exp(-dtS * omega / (2 * Math.PI));
    y *= fade;
    w *= fade;
  }

  /** What is to be added to the density of the angular frequency's noise; 0 in steady flight. */
  double density() {
    return density;
  }
}
