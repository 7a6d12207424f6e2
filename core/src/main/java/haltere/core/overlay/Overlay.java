package haltere.core.overlay;

/**
 * Draws a snapshot of results: a pure function from the snapshot and a time to marks.
 *
 * <p>Thread rule: called on whichever thread draws; the snapshot is immutable, and the overlay
 * itself has no state.
 *
 * @param <T> type of the snapshot
 * @since 0.1
 */
@FunctionalInterface
public interface Overlay<T> {
  /**
   * Longest extrapolation of results, seconds, so that old results do not drift out of the picture.
   */
  double MAX_AHEAD_S = 0.1;

  /**
   * Draws the results as of their own time.
   *
   * @param snapshot what was published last
   * @param canvas takes the marks
   */
  void draw(T snapshot, OverlayCanvas canvas);

  /**
   * Draws the results extrapolated to a time.
   *
   * @param snapshot what was published last
   * @param timeUs the displayed time, on the clock of the events, microseconds
   * @param canvas takes the marks
   */
  default void drawAt(T snapshot, long timeUs, OverlayCanvas canvas) {
    draw(snapshot, canvas);
  }

  /**
   * Time from a snapshot to the displayed time.
   *
   * @param snapshotUs time of the snapshot, microseconds
   * @param timeUs the displayed time, microseconds
   * @return seconds, 0 to {@link #MAX_AHEAD_S}
   */
  static double aheadS(long snapshotUs, long timeUs) {
    return timeUs <= snapshotUs ? 0 : Math.min(MAX_AHEAD_S, (timeUs - snapshotUs) * 1e-6);
  }
}
