package haltere.core.camera;

import haltere.core.settings.Parameter;
import java.util.List;

/**
 * The bias currents and voltages of a sensor, by name.
 *
 * <p>Thread rule: all methods may be called from any thread; a change is in effect when the method
 * returns.
 *
 * @since 0.1
 */
public interface Biases {
  /**
   * The available biases, with ranges, units and effects.
   *
   * @return in the order for users
   */
  List<Parameter> parameters();

  /**
   * The value in effect.
   *
   * @param name of one of {@link #parameters()}
   * @return in its unit
   * @throws IllegalArgumentException if there is none of that name, listing those that there are
   */
  double get(String name);

  /**
   * Sets a bias.
   *
   * @param name of one of {@link #parameters()}
   * @param value in its unit; rounded to the nearest possible value
   * @throws IllegalArgumentException if there is none of that name, or the value is out of range
   * @throws CameraProblem if the camera rejects it; the old value stays
   */
  void set(String name, double value) throws CameraProblem;

  /**
   * Names of the predefined sets of values.
   *
   * @return names such as {@code fast} and {@code slow}
   */
  List<String> sets();

  /**
   * Sets all biases to the values of a set.
   *
   * @param name one of {@link #sets()}
   * @throws IllegalArgumentException if there is none of that name, listing those that there are
   * @throws CameraProblem if the camera rejects them; the old values stay
   */
  void apply(String name) throws CameraProblem;
}
