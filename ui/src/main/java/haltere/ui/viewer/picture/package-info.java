/**
 * The picture of the sensor. {@code DisplaySink} receives the chain's output, {@code
 * PictureRenderer} paints it on its own thread into one of three preallocated frames, {@code
 * EventView} shows the newest at each pulse of JavaFX, with mouse tools.
 */
package haltere.ui.viewer.picture;
