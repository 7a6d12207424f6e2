/**
 * Events and marks as pixels, for the viewer and for written pictures, without JavaFX. Thread rule,
 * unless a type states another: one thread at a time.
 */
package haltere.ui.rendering;
