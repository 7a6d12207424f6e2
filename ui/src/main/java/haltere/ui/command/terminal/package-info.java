/**
 * Terminal output of commands during their work, and their orderly end: redrawn lines, formatted
 * numbers, standard output. Depends on no command.
 */
package haltere.ui.command.terminal;
