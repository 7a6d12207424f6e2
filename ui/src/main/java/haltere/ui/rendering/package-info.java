/**
 * Events and marks as pixels, without a window: used by the viewer and by everything that writes
 * pictures. Imports no JavaFX.
 */
package haltere.ui.rendering;
