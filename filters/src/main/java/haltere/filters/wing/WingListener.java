package haltere.filters.wing;

/**
 * Receives the results of a {@link haltere.filters.wing.tracker.WingTracker WingTracker} on the
 * thread of the tracker.
 */
@FunctionalInterface
public interface WingListener {
  /**
   * Receives a result.
   *
   * @param result of one of the kinds of {@link WingResult}
   */
  void accept(WingResult result);

  /**
   * Whether results of a kind are requested at each tick or event: {@link WingEstimate} (with
   * pairs, averages and differences), {@link WingSnapshot}, {@link WingMeasurement} or {@link
   * WingVariances}. Asked at each tick and at each packet.
   *
   * @param kind of result
   * @return true to get them
   */
  default boolean isRequested(Class<? extends WingResult> kind) {
    return kind == WingEstimate.class;
  }
}
