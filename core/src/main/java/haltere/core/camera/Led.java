package haltere.core.camera;

/**
 * A camera with an LED that identifies it.
 *
 * <p>Thread rule: all methods may be called from any thread.
 *
 * @since 0.1
 */
public interface Led {
  /** State of the light. */
  enum LedState {
    /** Off. */
    OFF,
    /** On. */
    ON,
    /** Blinking. */
    BLINKING
  }

  /**
   * Switches the light.
   *
   * @param state the new state
   * @throws CameraProblem if the camera rejects it or is lost
   */
  void setLed(LedState state) throws CameraProblem;
}
