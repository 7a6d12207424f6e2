/**
 * Events and marks as pixels, without a window: used by the viewer and by everything that writes
 * pictures. Imports no JavaFX. Thread rule: a type that names none of its own is for one thread at
 * a time.
 */
package haltere.ui.rendering;
