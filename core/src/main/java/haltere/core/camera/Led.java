package haltere.core.camera;

/**
 * A camera with an LED that identifies it.
 *
 * <p>Thread rule: all methods may be called from any thread.
 *
 * @since 0.1
 */
public interface Led {
  /** What the light does. */
  enum State {
    /** Dark. */
    OFF,
    /** Bright. */
    ON,
    /** Both by turns. */
    BLINKING
  }

  /**
   * Switches the light.
   *
   * @param state what it shall do
   * @throws CameraProblem if the camera refuses or is gone
   */
  void setLed(State state) throws CameraProblem;
}
