/** Filters that remove what no movement in the scene has caused. */
package haltere.filters.noise;
