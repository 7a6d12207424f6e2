/**
 * Reports as one HTML page: what was read, with which settings, plots, pictures and the command. A
 * page needs neither network nor scripts. Knows plots and pictures, and no command.
 */
package haltere.ui.command.report;
