/** Frequencies at which single pixels flicker, and the filter that publishes them. */
package haltere.filters.frequency;
