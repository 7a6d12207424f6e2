package haltere.ui.viewer.feature;

/**
 * Something that the window offers: it adds its actions, panels and tools, and listens to what is
 * open. Features do not know each other; {@code ViewerFeatures} lists them.
 */
@FunctionalInterface
public interface ViewerFeature {
  /** Adds what it offers; called once, before the window is shown. */
  void install(ViewerContext window);
}
