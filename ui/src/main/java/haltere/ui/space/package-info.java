/** A body in space with its cameras, drawn as marks; independent of a toolkit. */
package haltere.ui.space;
