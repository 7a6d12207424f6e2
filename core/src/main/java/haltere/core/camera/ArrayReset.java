package haltere.core.camera;

/**
 * A camera all of whose pixels can be reset at once.
 *
 * <p>Thread rule: all methods may be called from any thread.
 *
 * @since 0.1
 */
public interface ArrayReset {
  /**
   * Resets all pixels for a few microseconds: the present light becomes their reference.
   *
   * @throws CameraProblem if the camera refuses or is gone
   */
  void resetPixels() throws CameraProblem;

  /**
   * Holds all pixels in reset, so that there are no events, or releases them.
   *
   * @param hold true to hold, false to release
   * @throws CameraProblem if the camera refuses or is gone
   */
  void holdPixels(boolean hold) throws CameraProblem;
}
