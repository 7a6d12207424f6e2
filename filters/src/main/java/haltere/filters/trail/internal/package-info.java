/** Trails of objects in the picture: what was seen of each, and how it is drawn. */
package haltere.filters.trail.internal;
