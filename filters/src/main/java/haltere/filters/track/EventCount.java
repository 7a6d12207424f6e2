package haltere.filters.track;

/** Whose events are counted until tracks are updated. */
public enum EventCount {
  /** Each track waits for the events of its own cluster. */
  EACH_CLUSTER,
  /** All tracks are updated when all clusters together have the events: what the original does. */
  ALL_CLUSTERS
}
