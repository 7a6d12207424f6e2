package haltere.filters.estimation;

/**
 * What an estimator holds to be true at a time, and how sure it is.
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
   * @return in the state's own unit
   */
  public double value(int index) {
    return state.get(index);
  }

  /**
   * How sure the estimator is of one entry.
   *
   * @param index from 0
   * @return one standard deviation, in the state's own unit
   */
  public double standardDeviation(int index) {
    return Math.sqrt(covariance.get(index, index));
  }
}
