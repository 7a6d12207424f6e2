package haltere.filters.wing;

/** How wings are tracked. */
public enum WingMethod {
  /** The extended Kalman filter. */
  EKF,
  /** The weighted running average. */
  WRA,
  /** The extended Kalman filter, and the running average beside it for comparison. */
  BOTH
}
