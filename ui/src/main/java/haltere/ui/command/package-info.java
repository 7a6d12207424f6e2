/**
 * The command line, one class per command. Nothing here needs a display; the rules that all
 * commands keep (statuses, one line per error, atomic outputs) stand in {@code HaltereProgram},
 * {@code Subcommand} and the option groups.
 */
package haltere.ui.command;
