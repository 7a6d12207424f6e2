/**
 * Three-dimensional orientation of a body that several calibrated cameras see as a line.
 *
 * <ul>
 *   <li>{@link haltere.filters.orientation.BodyOrientationEstimator} is the whole of it for one
 *       body: position, axis, rates, head or tail, at each time from the observations up to then.
 *       {@link haltere.filters.orientation.OrientationTrack} keeps a track and goes back over it.
 *   <li>{@link haltere.filters.orientation.camera.CameraModel} is a camera: a matrix and a {@link
 *       haltere.filters.orientation.camera.Lens}; {@link
 *       haltere.filters.orientation.camera.LineObservation} is what it saw.
 *   <li>{@link haltere.filters.orientation.line.BodyLineTracker} finds such a line in events.
 * </ul>
 *
 * <p>World units are metres, image units pixels in the camera's own coordinates (whatever its
 * matrix maps to), angles radians unless a name says otherwise. Nothing here knows of the chain
 * except what is called a filter.
 *
 * @since 0.1
 */
package haltere.filters.orientation;
