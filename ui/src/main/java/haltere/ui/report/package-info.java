/**
 * Reports as one HTML page: what was read, with which settings, plots, pictures and the command. A
 * page needs neither network nor scripts. Knows plots and pictures, no command and no JavaFX.
 */
package haltere.ui.report;
