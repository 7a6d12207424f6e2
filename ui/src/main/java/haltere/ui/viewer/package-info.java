/**
 * The window. {@code ViewerWindow} joins its parts, {@code Sessions} opens what they show. What a
 * person can do is brought by features, listed in {@code ViewerFeatures}: each adds its actions,
 * panels and mouse tools by way of a {@code ViewerContext}. Small features stand here, larger ones
 * in packages of their own. From below: {@code controls}; {@code action}, {@code chain}, {@code
 * picture} and {@code playback}; {@code plots} and {@code session}; {@code feature}, which holds
 * the panels and what features may use; the features {@code wings}, {@code space}, {@code cameras},
 * {@code compare}, {@code saving}, {@code road}, {@code file} and {@code start}; this package.
 *
 * <p>Thread rule, for all of these packages: nodes are touched on the JavaFX thread only, and a
 * type of a package that names no rule of its own belongs to that thread; values may go anywhere.
 * That thread never reads a file, never runs a filter and never waits for another thread. The
 * player's processing thread hands copies of what comes out of the chain to a thread that paints
 * them into one of three preallocated frames ({@code DisplaySink}, {@code PictureThread}); at each
 * pulse of JavaFX the window fetches the newest finished one. What the window wants of the player
 * or the chain it asks for by a command; what came of it comes back by {@code Platform.runLater}.
 * Files are opened, scanned and closed on background threads ({@code BackgroundWork}).
 */
package haltere.ui.viewer;
