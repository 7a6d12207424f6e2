package haltere.filters.wing;

/** What the extended Kalman filter takes for its object. */
public enum WingModel {
  /** A filter for each wing, over both its edges. */
  WINGS,
  /** A filter for each of the four edges, a plain sinusoid. */
  EDGES,
  /**
   * The tracker of Cardinale (2006): its search, angles about the body's centre, a filter for each
   * edge, process noise at each update whatever the time since the last one.
   */
  ORIGINAL
}
