/**
 * Reports as one HTML page: input, settings, plots, pictures and the command, without network or
 * scripts. Depends on no command. Thread rule, unless a type states another: one thread at a time.
 */
package haltere.ui.command.report;
