/**
 * The picture of the sensor. {@code DisplaySink} gathers what comes out of the chain, {@code
 * PictureMaker} paints it, on a thread of its own, into one of three preallocated frames; {@code
 * EventView} shows the newest at each pulse of JavaFX, with the tools that a person works with on
 * it.
 */
package haltere.ui.viewer.picture;
