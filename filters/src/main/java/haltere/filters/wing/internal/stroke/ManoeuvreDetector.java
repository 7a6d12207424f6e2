package haltere.filters.wing.internal.stroke;

/**
 * Notices a manoeuvre: the phase runs away from what is expected by more than it usually does
 * ({@link UsualPhase}). The frequency's process noise is then raised, by as much as the phase is
 * off, and falls back slowly, because a manoeuvre that has begun goes on.
 *
 * <p>A fly's wings are driven as one: what both phases are off by together tells of a manoeuvre
 * sooner, and noise is less often taken for one, than each does alone. A wing that runs away alone
 * has to do so more clearly.
 */
final class RunAway {
  /** Density of the frequency's noise for each squared radian by which the phase runs away. */
  private static final double DENSITY = 4e8;

  private static final double HOLD_S = 0.03;
  private static final double MIN_DENSITY = 1;

  private final UsualPhase together = new UsualPhase(20, 1.5, 6);
  private final UsualPhase alone = new UsualPhase(26, 6, 12);
  private double y;
  private double w;
  private double density;

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
   * Looks, about once in a millisecond; the residuals of the last beat count. The other wing is the
   * one that is driven together with this one; null if none is known.
   */
  void look(double dtS, double omega, double most, RunAway other) {
    if (w > 0) {
      double excess = excess(other);
      density = Math.max(density * Math.exp(-dtS / HOLD_S), Math.min(most, DENSITY * excess));
      if (density < MIN_DENSITY) {
        density = 0;
      }
    }
    double fade = Math.exp(-dtS * omega / (2 * Math.PI));
    y *= fade;
    w *= fade;
  }

  private double excess(RunAway other) {
    boolean calm = density == 0;
    if (other == null) {
      return together.excess(y, w, calm);
    }
    return Math.max(
        alone.excess(y, w, calm),
        together.excess(y + other.y, w + other.w, calm && other.density == 0));
  }

  /** What is to be added to the density of the angular frequency's noise; 0 in steady flight. */
  double density() {
    return density;
  }
}
