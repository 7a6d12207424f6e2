/**
 * The command line, one class per command. Nothing here needs a display; the rules that all
 * commands keep (statuses, one line per error, atomic outputs) stand in {@code HaltereProgram},
 * {@code Subcommand} and the option groups. What they write is made in {@code results}, what they
 * say meanwhile in {@code terminal}; neither knows a command.
 */
package haltere.ui.command;
