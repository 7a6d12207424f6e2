package haltere.filters.track;

/** What a track takes as a measurement of its place. */
public enum MeasurementSource {
  /**
   * The mean of the events since the last update, with the variance that their scatter and their
   * number give it. Its errors are independent of those before.
   */
  EVENTS,
  /**
   * The centre of the cluster, which averages over its own past, with a stated variance: what the
   * original does.
   */
  CENTRE
}
