/** A body in space with the cameras that see it, drawn as marks; knows no toolkit. */
package haltere.ui.space;
