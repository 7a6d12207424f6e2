/**
 * Outputs of the window: recordings, chains, pictures, films, tables, and live results for other
 * programs, all written in the background.
 */
package haltere.ui.viewer.saving;
