package haltere.filters.wing;

/** Method of tracking. */
public enum WingMethod {
  /** The extended Kalman filter. */
  EKF,
  /** The weighted running average. */
  WRA,
  /** Both, for comparison. */
  BOTH
}
