/**
 * The window. One class per panel; {@code ViewerPanels} lays them out and keeps them up to date,
 * {@code SessionOpener} opens what they show, {@code ViewerWindow} holds it together. What a person
 * can do is brought by {@code ViewerFeature}s, listed in {@code ViewerFeatures}: each adds its
 * {@code ViewerAction}s, from which menus, keys, command palette and the list of keys are made, and
 * its panels and mouse tools, by way of a {@code ViewerContext}.
 *
 * <p>Thread rule, for the whole package: nodes are touched on the JavaFX thread only, and that
 * thread never reads a file, never runs a filter and never waits for another thread. The player's
 * processing thread hands copies of what comes out of the chain to a thread that paints them into
 * one of three preallocated frames ({@code DisplaySink}, {@code PictureThread}); at each pulse of
 * JavaFX the window fetches the newest finished one. What the window wants of the player or the
 * chain it asks for by a command; what came of it comes back by {@code Platform.runLater}. Files
 * are opened, scanned and closed on background threads ({@code BackgroundWork}).
 */
package haltere.ui.viewer;
