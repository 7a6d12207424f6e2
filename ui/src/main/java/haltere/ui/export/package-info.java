/** Pictures in a row as films: GIF by the Java runtime, MP4 by a program that is looked for. */
package haltere.ui.export;
