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
   * The biases that there are, with ranges, units and what each does.
   *
   * @return in the order in which a person wants them
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
   * @param value in its unit; rounded to the nearest that the camera can set
   * @throws IllegalArgumentException if there is none of that name, or the value is out of range
   * @throws CameraProblem if the camera does not take it; the old value stays
   */
  void set(String name, double value) throws CameraProblem;

  /**
   * Sets of values that belong together.
   *
   * @return names such as {@code fast} and {@code slow}
   */
  List<String> sets();

  /**
   * Sets all biases to the values of a set.
   *
   * @param name one of {@link #sets()}
   * @throws IllegalArgumentException if there is none of that name, listing those that there are
   * @throws CameraProblem if the camera does not take them; the old values stay
   */
  void apply(String name) throws CameraProblem;
}
