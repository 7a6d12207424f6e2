package haltere.filters.track;

/** What a track takes as a measurement of its place. */
public enum MeasurementSource {
  /**
   * The middle of the round outline on which the events lie, of which no more than a part need be
   * seen. Where there is no such outline, as with {@link #EVENTS}. On a road, the edge at which a
   * vehicle meets it nearest to the camera.
   */
  OUTLINE,
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
