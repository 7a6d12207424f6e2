package haltere.filters.wing;

/** What the extended Kalman filter takes for its object. */
public enum WingModel {
  /** A filter for each wing, over both its edges. */
  WINGS,
  /** A filter for each of the four edges, a plain sinusoid, as the source has it. */
  EDGES,
  /**
   * The same, but process noise is added at each update, whatever the time since the last one, as
   * the source did.
   */
  EDGES_BY_UPDATE
}
