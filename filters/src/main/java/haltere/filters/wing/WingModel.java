package haltere.filters.wing;

/** What the extended Kalman filter takes for its object. */
public enum WingModel {
  /** A filter for each wing, over both its edges. */
  WINGS,
  /** A filter for each of the four edges, a plain sinusoid, as the source has it. */
  EDGES
}
