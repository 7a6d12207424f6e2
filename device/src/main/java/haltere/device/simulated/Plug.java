package haltere.device.simulated;

/**
 * The plug of a simulated camera: a facet for simulating disconnection.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
public interface Plug {
  /** Pulls the plug: the stream ends with a {@code DeviceLost}. */
  void unplug();

  /** Puts the plug back: a camera that was opened to reconnect begins a new stream. */
  void plugIn();

  /**
   * Whether the camera is plugged in.
   *
   * @return true until it is unplugged
   */
  boolean isPluggedIn();
}
