/**
 * What commands write and sum up: tables of what filters publish, readings beside the events, files
 * of simulated flights. Each file appears whole or not at all.
 */
package haltere.ui.command.results;
