package haltere.filters.estimation;

/** What became of a measurement. */
public enum UpdateOutcome {
  /** The estimate has taken it in. */
  APPLIED,
  /** Its innovation lies outside the gate; the estimate is as before. */
  GATED,
  /** It, or its innovation covariance, is not finite or not positive; the estimate is as before. */
  UNUSABLE
}
