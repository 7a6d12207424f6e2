package haltere.filters.estimation;

/** One thing that an estimator did, with every intermediate of it: for tests, plots, smoothing. */
public sealed interface FilterStep permits Launch, Prediction, Correction {
  /** {@return the estimate after the step: state, covariance and time} */
  Estimate estimate();
}
