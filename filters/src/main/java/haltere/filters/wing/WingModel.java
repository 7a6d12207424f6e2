package haltere.filters.wing;

/** Models of the Kalman filter. */
public enum WingModel {
  /** A filter for each wing, over both its edges. */
  WINGS,
  /** A filter for each of the four edges, a plain sinusoid. */
  EDGES,
  /**
   * The tracker of Cardinale (2006): its search, angles about the centre of the body, a filter for
   * each edge, process noise at each update independent of the time step.
   */
  ORIGINAL
}
