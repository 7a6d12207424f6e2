package haltere.ui.viewer.controls;

/** A focused node that may consume arrow keys, Home, End and the page keys. */
public interface ArrowKeys {
  /** Whether it consumes them now; otherwise they belong to playback. */
  boolean consumesArrows();
}
