package haltere.filters.estimation;

/** What became of a measurement. */
public enum UpdateOutcome {
  /** The estimate has taken it in. */
  APPLIED,
  /** Its innovation lies outside the gate; the estimate is as before. */
  GATED,
  /**
   * Outside the gate, and so were so many before it in a row that the filter has lost its target;
   * it needs a new launch, or a wider gate.
   */
  LOCK_LOST,
  /** It, or its innovation covariance, is not finite or not positive; the estimate is as before. */
  UNUSABLE
}
