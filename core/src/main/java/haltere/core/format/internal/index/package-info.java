/** The time index of a recording, and its storage. */
package haltere.core.format.internal.index;
