package haltere.filters.estimation;

/** Outcome of an update. */
public enum UpdateOutcome {
  /** The estimate was updated. */
  APPLIED,
  /** Its innovation is outside the gate; the estimate is unchanged. */
  GATED,
  /** It, or its innovation covariance, is not finite or not positive; the estimate is unchanged. */
  UNUSABLE
}
