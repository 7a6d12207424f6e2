/**
 * Frequencies at which single pixels and regions flicker, and the filter that publishes those of
 * pixels.
 */
package haltere.filters.frequency;
