package haltere.filters.wing;

/** How wings are tracked. */
public enum WingMethod {
  /** The extended Kalman filter. */
  EKF,
  /** The weighted running average. */
  WRA,
  /** Both, for comparison. */
  BOTH
}
