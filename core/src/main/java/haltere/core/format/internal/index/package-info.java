/** The time index of a recording, and where it is kept. */
package haltere.core.format.internal.index;
