package haltere.core.overlay;

/**
 * Draws a snapshot of results: a pure function from the snapshot to marks.
 *
 * <p>Thread rule: called on whichever thread draws; the snapshot is immutable, and the overlay
 * itself has no state.
 *
 * @param <T> type of the snapshot
 */
@FunctionalInterface
public interface Overlay<T> {
  /**
   * Draws.
   *
   * @param snapshot what was published last
   * @param canvas takes the marks
   */
  void draw(T snapshot, OverlayCanvas canvas);
}
