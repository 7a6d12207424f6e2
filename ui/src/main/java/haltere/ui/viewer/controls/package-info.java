/**
 * Buttons, icons, entries, questions and words, all alike in the whole window. They know settings
 * and units, but nothing of what the window shows.
 */
package haltere.ui.viewer.controls;
