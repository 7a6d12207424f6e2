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
   * Longest time by which results are carried on, seconds: one that is no longer reported does not
   * drift out of the picture.
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
   * Draws the results as they are expected to be at a time, from what is known in the snapshot.
   *
   * @param snapshot what was published last
   * @param timeUs the time that is shown, on the clock of the events, microseconds
   * @param canvas takes the marks
   */
  default void drawAt(T snapshot, long timeUs, OverlayCanvas canvas) {
    draw(snapshot, canvas);
  }

  /**
   * Time from a snapshot to the one that is shown.
   *
   * @param snapshotUs time of the snapshot, microseconds
   * @param timeUs the time that is shown, microseconds
   * @return seconds, 0 to {@link #MAX_AHEAD_S}
   */
  static double aheadS(long snapshotUs, long timeUs) {
    return timeUs <= snapshotUs ? 0 : Math.min(MAX_AHEAD_S, (timeUs - snapshotUs) * 1e-6);
  }
}
