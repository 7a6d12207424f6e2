package haltere.core.camera;

import haltere.core.settings.Parameter;
import java.util.List;

/**
 * All settings of a camera.
 *
 * <p>Thread rule: all methods may be called from any thread.
 *
 * @since 0.1
 */
public interface Configuration {
  /**
   * The adjustable settings except the biases; names are {@code group.name}.
   *
   * @return empty if there are none
   */
  List<Parameter> parameters();

  /**
   * The value in effect.
   *
   * @param name of one of {@link #parameters()}
   * @return of the parameter's type
   * @throws IllegalArgumentException if there is none of that name, listing those that there are
   */
  Object get(String name);

  /**
   * Changes a setting.
   *
   * @param name of one of {@link #parameters()}
   * @param value of the parameter's type, or a text of it
   * @throws IllegalArgumentException if there is none of that name, or the value is out of range
   * @throws CameraProblem if the camera rejects it; the old value stays
   */
  void set(String name, Object value) throws CameraProblem;

  /**
   * All settings and biases as text for the header of a recording.
   *
   * @return lines of {@code name = value unit}, the first of which names the camera
   */
  String text();
}
