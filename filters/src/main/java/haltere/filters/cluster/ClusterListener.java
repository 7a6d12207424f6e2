package haltere.filters.cluster;

/**
 * Receives updates and reports of a {@link ClusterTracker}, on its thread. It must not pass events
 * to the tracker.
 */
public interface ClusterListener {
  /**
   * All clusters are up to date.
   *
   * @param timeUs a whole multiple of the interval of updates, microseconds
   */
  default void updated(long timeUs) {}

  /**
   * A report is due.
   *
   * @param timeUs a time of the rate of reports, microseconds
   */
  default void reported(long timeUs) {}

  /**
   * {@return whether updates and reports go on although there is no cluster, false unless
   * overridden} A tracker without clusters skips them otherwise.
   */
  default boolean isWaiting() {
    return false;
  }
}
