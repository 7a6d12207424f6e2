package haltere.filters.wing;

/**
 * Takes the results of a {@link haltere.filters.wing.tracker.WingTracker WingTracker} as they come,
 * on the thread that tracks.
 */
@FunctionalInterface
public interface WingListener {
  /**
   * Takes a result.
   *
   * @param result of one of the kinds of {@link WingResult}
   */
  void take(WingResult result);

  /**
   * Whether results of a kind are wanted at each tick, or at each event: {@link WingEstimate} (with
   * pairs, averages and differences), {@link WingSnapshot}, {@link WingMeasurement} or {@link
   * WingVariances}. Asked at each tick and at each packet.
   *
   * @param kind of result
   * @return true to get them
   */
  default boolean wants(Class<? extends WingResult> kind) {
    return kind == WingEstimate.class;
  }
}
