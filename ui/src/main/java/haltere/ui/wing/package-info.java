/** Logs of tracked wings, for the command line and the viewer. */
package haltere.ui.wing;
