package haltere.core.camera;

/**
 * A camera whose clock can be set to 0.
 *
 * @since 0.1
 */
public interface TimestampReset {
  /**
   * Sets the clock to 0; the stream has a {@link haltere.core.stream.Reset} there. Callable from
   * any thread.
   *
   * @throws CameraProblem if the camera refuses or is gone
   */
  void resetTimestamps() throws CameraProblem;
}
