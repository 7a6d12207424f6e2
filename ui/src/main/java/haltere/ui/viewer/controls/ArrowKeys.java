package haltere.ui.viewer.controls;

/**
 * A node that may want the arrow keys, Home, End and the pages for itself while it has the focus.
 */
public interface ArrowKeys {
  /** Whether it wants them now; otherwise they belong to playback. */
  boolean keepsArrows();
}
