package haltere.filters.wing;

/**
 * A manual change of a number of a running Kalman filter.
 *
 * @param part the wing, or the edge with a filter for each edge
 * @param table the table
 * @param row from 0
 * @param column from 0; used for the covariance only
 * @param value the new number, in the units of {@link WingFilterState}; NaN returns noise to the
 *     settings or to the estimator that adapts it; 0 for the measurement noise adapts it
 */
public record WingFilterEdit(WingPart part, Table table, int row, int column, double value) {
  /** Editable quantities. */
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

  public WingFilterEdit {
    boolean noise = table == Table.PROCESS_NOISE || table == Table.MEASUREMENT_NOISE;
    if (!Double.isFinite(value) && !(noise && Double.isNaN(value))) {
      throw new IllegalArgumentException("a number is needed, not " + value);
    }
  }

  /** {@return whether noise returns from manual to automatic} */
  public boolean restoresAutomatic() {
    return Double.isNaN(value);
  }

  /**
   * The number as a variance.
   *
   * @return the value, at least 0
   * @throws IllegalArgumentException if the value is negative
   */
  public double notNegative() {
    if (value < 0) {
      throw new IllegalArgumentException("a variance cannot be negative: " + value);
    }
    return value;
  }
}
