package haltere.ui.viewer.feature;

/** A feature that works with the parts of its window. */
public abstract class WindowFeature implements ViewerFeature {
  /** The window, from the installation on. */
  protected ViewerContext window;

  @Override
  public final void install(ViewerContext installed) {
    window = installed;
    install();
  }

  /** Adds its parts to the window; called once. */
  protected abstract void install();
}
