package haltere.filters.track.kalman;

/** Hears what a {@link TrackEstimator} does. Thread rule: called on the thread that tracks. */
interface TrackListener {
  /** It is the time of a report: there are tracks to show, or for the first time none any more. */
  void reported(long timeUs);

  /** A track that is shown has compared a measurement, and taken it in or not. */
  void updated(Track track, Measurement measurement, boolean accepted);

  /**
   * A vehicle on a road that is shown has come to the end of a step; it may be asked from where.
   */
  default void moved(Track track, long timeUs, WayBack back) {
    // only those who count vehicles follow them
  }

  /** A track that was shown has ended. */
  void ended(int id);
}
