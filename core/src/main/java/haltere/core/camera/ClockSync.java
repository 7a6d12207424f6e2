package haltere.core.camera;

/**
 * A camera whose clock can follow that of another one over a wire.
 *
 * <p>Thread rule: all methods may be called from any thread.
 *
 * @since 0.1
 */
public interface ClockSync {
  /**
   * Whether the camera is the clock master.
   *
   * @return true for a master, false for one that follows another
   * @throws CameraProblem if the camera cannot report it or is lost
   */
  boolean isMaster() throws CameraProblem;

  /**
   * Selects its clock.
   *
   * @param master true for its own clock, with triggers from the input; false for the clock at the
   *     input
   * @throws CameraProblem if the camera refuses or is gone
   */
  void setMaster(boolean master) throws CameraProblem;
}
