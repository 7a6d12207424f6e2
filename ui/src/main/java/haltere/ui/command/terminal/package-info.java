/**
 * What commands say on a terminal while they work, and how they end when they are told to: lines
 * that are drawn again and again, numbers as a person reads them, the standard output. Nothing here
 * knows what a command does.
 */
package haltere.ui.command.terminal;
