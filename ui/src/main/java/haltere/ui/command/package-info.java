/**
 * The command line, one class per command, without a display. {@code HaltereProgram}, {@code
 * Subcommand} and the option groups implement the common rules: statuses, one line per error,
 * atomic outputs. Outputs are in {@code results}, terminal messages in {@code terminal}; neither
 * depends on a command.
 */
package haltere.ui.command;
