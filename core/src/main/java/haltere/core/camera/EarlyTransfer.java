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
   * How long it keeps an event at most.
   *
   * @return microseconds
   */
  int longestDelayUs();

  /**
   * Chooses how long it keeps an event.
   *
   * @param delayUs microseconds; rounded to what the camera can do
   * @throws IllegalArgumentException if it is out of the camera's range, which the message states
   * @throws CameraProblem if the camera refuses or is gone
   */
  void setLongestDelayUs(int delayUs) throws CameraProblem;
}
