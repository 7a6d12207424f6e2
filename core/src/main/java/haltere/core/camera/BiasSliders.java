package haltere.core.camera;

/**
 * Four sliders, each of which changes several biases, for users unfamiliar with biases. In the
 * middle, the biases are those of the last applied set.
 *
 * <p>Thread rule: all methods may be called from any thread; a change is in effect when the method
 * returns.
 *
 * @since 0.1
 */
public interface BiasSliders {
  /** The sliders. */
  enum Slider {
    /** Bandwidth of a pixel: right is faster and noisier. */
    BANDWIDTH,
    /** Change of light for an event: right is larger. */
    THRESHOLD,
    /** Dead time of a pixel after an event: right is longer. */
    REFRACTORY_PERIOD,
    /** Balance of the polarities: right favours ON. */
    BALANCE
  }

  /**
   * Position of a slider.
   *
   * @param slider which
   * @return -1 to 1, 0 in the middle
   */
  double get(Slider slider);

  /**
   * Moves a slider.
   *
   * @param slider which
   * @param value -1 to 1
   * @throws IllegalArgumentException if the value is not in this range
   * @throws CameraProblem if the camera rejects the biases; the slider stays
   */
  void set(Slider slider, double value) throws CameraProblem;
}
