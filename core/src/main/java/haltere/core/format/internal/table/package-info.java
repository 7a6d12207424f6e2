/** Tables beside the events of a recording. */
package haltere.core.format.internal.table;
