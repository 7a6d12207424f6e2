/** Filters that remove events not caused by movement in the scene. */
package haltere.filters.noise;
