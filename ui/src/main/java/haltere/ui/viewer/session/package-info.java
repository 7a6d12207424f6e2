/**
 * What is open, and how it is opened: a playable, its chain, its player and the sink that makes its
 * pictures. Knows no node of the window.
 */
package haltere.ui.viewer.session;
