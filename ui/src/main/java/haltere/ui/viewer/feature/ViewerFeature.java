package haltere.ui.viewer.feature;

/**
 * A feature of the window: it adds actions, panels and tools, and observes the open session.
 * Features are independent of each other; {@code ViewerFeatures} lists them.
 */
@FunctionalInterface
public interface ViewerFeature {
  /** Adds its actions, panels and tools; called once, before the window is shown. */
  void install(ViewerContext window);
}
