/**
 * What leaves the window: recordings, chains, pictures, films, tables, and live results for other
 * programs. All of it is written in the background.
 */
package haltere.ui.viewer.saving;
