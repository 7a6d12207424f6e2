/**
 * What a feature of the window is, and all that it may use: {@code ViewerContext} hands it the
 * actions, the panels, the chain, the transport, what is open, threads for files, the status line
 * and what is kept from one start to the next. Features stand in packages of their own and do not
 * know each other.
 */
package haltere.ui.viewer.feature;
