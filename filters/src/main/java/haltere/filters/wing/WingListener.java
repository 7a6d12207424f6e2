package haltere.filters.wing;

/**
 * Takes the results of a {@link haltere.filters.wing.tracker.WingTracker WingTracker} as they come,
 * on the thread that tracks. Results that nobody wants are not made.
 */
public interface WingListener {
  /**
   * Whether estimates and pairs are wanted.
   *
   * @return true to get them at each tick
   */
  default boolean wantsEstimates() {
    return true;
  }

  /**
   * Whether snapshots are wanted.
   *
   * @return true to get them at each tick
   */
  default boolean wantsSnapshots() {
    return false;
  }

  /**
   * Whether each event that is taken in is wanted.
   *
   * @return true to get them
   */
  default boolean wantsMeasurements() {
    return false;
  }

  /**
   * Whether the covariances of the filters are wanted.
   *
   * @return true to get them at each tick
   */
  default boolean wantsVariances() {
    return false;
  }

  /**
   * An event that the method has taken in.
   *
   * @param measurement with what was expected of it
   */
  default void measurement(WingMeasurement measurement) {}

  /**
   * How sure a filter is.
   *
   * @param variances of a wing, or of an edge
   */
  default void variances(WingVariances variances) {}

  /**
   * The Kalman filter less the running average, where both run.
   *
   * @param difference of a wing
   */
  default void difference(WingDifference difference) {}

  /**
   * An estimate of an edge or of a wing.
   *
   * @param estimate by the method that is set
   */
  default void estimate(WingEstimate estimate) {}

  /**
   * What the running average makes of a wing, where it runs beside the Kalman filter.
   *
   * @param estimate by the running average
   */
  default void average(WingEstimate estimate) {}

  /**
   * Both wings against each other.
   *
   * @param pair at a tick
   */
  default void pair(WingPair pair) {}

  /**
   * A beat that has ended.
   *
   * @param beat of one wing
   */
  default void beat(WingBeat beat) {}

  /**
   * Where the fly was found.
   *
   * @param geometry of the fly, with what a person says of it
   */
  default void geometry(FlyGeometry geometry) {}

  /**
   * A step of the search or a change of what is tracked.
   *
   * @param state the step
   */
  default void state(WingTrackerState state) {}

  /**
   * Everything at a tick.
   *
   * @param snapshot to be drawn
   */
  default void snapshot(WingSnapshot snapshot) {}

  /**
   * A person has changed a Kalman filter.
   *
   * @param change what was done
   */
  default void byHand(WingByHand change) {}
}
