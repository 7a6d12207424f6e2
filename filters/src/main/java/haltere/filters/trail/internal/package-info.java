/** Trails of objects in the picture: their states and drawing. */
package haltere.filters.trail.internal;
