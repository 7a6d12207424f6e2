/**
 * Orientation in space of a body that several calibrated cameras see as a line.
 *
 * <ul>
 *   <li>{@link haltere.filters.orientation.BodyOrientationEstimator} estimates position, axis,
 *       rates, head and tail of one body online. {@link
 *       haltere.filters.orientation.OrientationTrack} smooths a whole track.
 *   <li>{@link haltere.filters.orientation.camera.CameraModel} is a camera: a matrix and a {@link
 *       haltere.filters.orientation.camera.Lens}; {@link
 *       haltere.filters.orientation.camera.LineObservation} is its observation.
 *   <li>{@link haltere.filters.orientation.line.BodyLineTracker} measures such a line from events.
 * </ul>
 *
 * <p>World units are metres, image units pixels in the camera's own coordinates (whatever its
 * matrix maps to), angles radians unless a name says otherwise. Only filters depend on the chain.
 *
 * @since 0.1
 */
package haltere.filters.orientation;
