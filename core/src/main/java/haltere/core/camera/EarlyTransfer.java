package haltere.core.camera;

/**
 * A camera that can send a partial buffer, which bounds the latency at low event rates.
 *
 * <p>Thread rule: all methods may be called from any thread.
 *
 * @since 0.1
 */
public interface EarlyTransfer {
  /**
   * Maximum time for which it buffers an event.
   *
   * @return microseconds
   */
  int maxDelayUs();

  /**
   * Sets the maximum time for which it buffers an event.
   *
   * @param delayUs microseconds; rounded to a step of the camera
   * @throws IllegalArgumentException if it is out of the camera's range, which the message states
   * @throws CameraProblem if the camera refuses or is gone
   */
  void setMaxDelayUs(int delayUs) throws CameraProblem;
}
