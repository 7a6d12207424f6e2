package haltere.filters.wing.internal.stroke;

/**
 * What a phase is usually off by in steady flight, as a share of what the noise of events explains,
 * and what is clearly more than that.
 */
final class UsualPhase {
  /** Events of one beat repeat each other's errors: so many of them count for one. */
  private static final double REPEATING = 3;

  private static final double FIRST = 0.25;
  private static final double FIRST_WEIGHT = 60;
  private static final double MAX_WEIGHT = 400;

  private final double times;
  private final double least;
  private final double most;
  private double usual = FIRST;
  private double weight = FIRST_WEIGHT;

  /**
   * What is usual where nothing was seen yet.
   *
   * @param times a square is clearly more if it is so many times the usual one
   * @param least and at least so many times what noise explains
   * @param most clear in any case, times what noise explains
   */
  UsualPhase(double times, double least, double most) {
    this.times = times;
    this.least = least;
    this.most = most;
  }

  /**
   * Square of what a phase is off by beyond what is usual.
   *
   * @param y weighted sum of residuals
   * @param w sum of weights times slopes
   * @param calm whether the fly flies steadily, so that this one counts as usual
   * @return squared radians; 0 where it is nothing unusual
   */
  double excess(double y, double w, boolean calm) {
    double square = y / w * (y / w);
    double variance = REPEATING / w;
    double clearly = Math.max(least, Math.min(most, times * usual));
    if (calm) {
      weight = Math.min(MAX_WEIGHT, weight + 1);
      usual += (Math.min(square / variance, clearly) - usual) / weight;
    }
    return Math.max(0, square - clearly * variance);
  }
}
