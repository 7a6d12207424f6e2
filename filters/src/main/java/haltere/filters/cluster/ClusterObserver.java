package haltere.filters.cluster;

/**
 * Hears from a {@link ClusterTracker} at regular times what its visible clusters have seen since
 * the time before: for estimators that build on clusters. Times are those of the events, whole
 * multiples of the observer's interval on their clock, whatever the packets are. While there is no
 * visible cluster the times jump, unless the observer is waiting.
 *
 * <p>Thread rule: called on the thread that calls the tracker, from within {@link
 * ClusterTracker#track}. Must not call the tracker; what it wants changed it says to the readings.
 */
public interface ClusterObserver {
  /**
   * Called at each time while there is a visible cluster, and once when there is none any more.
   *
   * @param timeUs the time, microseconds; all events before it have been seen, none at or after it
   * @param readings the visible clusters; valid only during the call
   */
  void clustersRead(long timeUs, ClusterReadings readings);

  /**
   * Called when two visible clusters have become one, between two readings.
   *
   * @param timeUs when, microseconds
   * @param keptId identity that goes on
   * @param lostId identity that has ended and is never given out again
   */
  default void clustersMerged(long timeUs, int keptId, int lostId) {
    // Whoever does not care sees the lost identity end.
  }

  /**
   * Called when a visible cluster turns out to be two things and goes on as one of them, so it is
   * elsewhere at once; the other gets its identity when it becomes visible.
   *
   * @param timeUs when, microseconds
   * @param id identity of the cluster
   */
  default void clusterParted(long timeUs, int id) {
    // Whoever does not care sees the cluster jump.
  }

  /**
   * Whether readings go on while there is no visible cluster. Until it says no, the times do not
   * jump, so an observer that waits for long has to say no some time.
   *
   * @param timeUs the time of the reading in question, microseconds
   * @return false unless overridden
   */
  default boolean isWaiting(long timeUs) {
    return false;
  }
}
