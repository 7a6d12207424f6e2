/** Marks drawn with JavaFX. */
package haltere.ui.overlay;
