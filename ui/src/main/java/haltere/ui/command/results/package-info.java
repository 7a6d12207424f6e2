/**
 * Outputs and summaries of commands: tables of results, samples, files of simulated flights. Files
 * are atomic.
 */
package haltere.ui.command.results;
