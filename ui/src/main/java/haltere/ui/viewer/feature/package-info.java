/**
 * Features of the window, and {@code ViewerContext}, which gives them actions, panels, chain,
 * playback, session, background threads, status line and saved settings. Features are in packages
 * of their own and independent of each other.
 */
package haltere.ui.viewer.feature;
