package haltere.filters.estimation;

/**
 * State of an estimator at a time with its covariance.
 *
 * @param timeS seconds since the estimator was launched
 * @param state x
 * @param covariance P
 */
public record Estimate(double timeS, ConstMatrix state, ConstMatrix covariance) {
  /**
   * One entry of the state.
   *
   * @param index from 0
   * @return in the entry's unit
   */
  public double value(int index) {
    return state.get(index);
  }

  /**
   * Standard deviation of one entry.
   *
   * @param index from 0
   * @return one standard deviation, in the entry's unit
   */
  public double standardDeviation(int index) {
    return Math.sqrt(covariance.get(index, index));
  }
}
