/**
 * Sessions: a playable, its chain, its player and the sink of its pictures. Independent of the
 * window's nodes.
 */
package haltere.ui.viewer.session;
