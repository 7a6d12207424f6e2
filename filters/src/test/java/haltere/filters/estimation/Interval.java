package haltere.filters.estimation;

/**
 * A closed interval, such as the band in which a statistic lies 95 % of the time.
 *
 * @param lower lower end
 * @param upper upper end
 */
public record Interval(double lower, double upper) {
  /**
   * Whether a value lies in it.
   *
   * @param value any; NaN lies nowhere
   * @return true from lower to upper, both included
   */
  public boolean contains(double value) {
    return value >= lower && value <= upper;
  }
}
