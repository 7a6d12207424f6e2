/** Braid: the tables and the calibration in a {@code .braidz} file. */
package haltere.core.format.internal.braidz;
