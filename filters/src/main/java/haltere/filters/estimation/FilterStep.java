package haltere.filters.estimation;

/** One thing that an estimator did, with every intermediate of it: for tests, plots, smoothing. */
public sealed interface FilterStep permits Launch, Prediction, Correction {
  /**
   * The estimate after the step.
   *
   * @return state, covariance and time
   */
  Estimate estimate();
}
