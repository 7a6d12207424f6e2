/**
 * Reports as one HTML page: what was read, with which settings, plots, pictures and the command. A
 * page needs neither network nor scripts. Knows plots and pictures, and no command. Thread rule: a
 * type that names none of its own is for one thread at a time.
 */
package haltere.ui.command.report;
