package haltere.filters.wing;

/**
 * A number of a Kalman filter that a person changes while it runs.
 *
 * @param part the wing, or the edge where there is a filter for each edge
 * @param table what is changed
 * @param row from 0
 * @param column from 0; taken by the covariance alone
 * @param value the new number, in the units of {@link WingFilterState}; for the noise of
 *     measurements 0 to learn it from the events
 */
public record WingFilterEdit(WingPart part, Table table, int row, int column, double value) {
  /** What can be changed. */
  public enum Table {
    /** The state x, one column. */
    STATE,
    /** Its covariance P. */
    COVARIANCE,
    /** The diagonal of the process noise Q. */
    PROCESS_NOISE,
    /** The variance R of a measurement, one number. */
    MEASUREMENT_NOISE
  }

  /** Checks that the number is one. */
  public WingFilterEdit {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException("a number is needed, not " + value);
    }
  }

  /**
   * The number as a variance.
   *
   * @return the value, at least 0
   * @throws IllegalArgumentException with a line for a person if the value is negative
   */
  public double notNegative() {
    if (value < 0) {
      throw new IllegalArgumentException("a variance cannot be negative: " + value);
    }
    return value;
  }
}
