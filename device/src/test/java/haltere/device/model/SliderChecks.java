package haltere.device.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.camera.BiasSliders;
import haltere.core.camera.BiasSliders.Slider;
import haltere.core.camera.Biases;
import haltere.core.camera.CameraProblem;
import haltere.core.settings.Parameter;
import java.util.LinkedHashMap;
import java.util.Map;

/** Properties of the sliders of every camera. */
final class SliderChecks {
  private static final int STEPS = 20;

  private SliderChecks() {}

  /**
   * Moves each slider from end to end: each bias only rises or only falls, stays in its range, and
   * is in the middle what it was.
   */
  static void check(Biases biases, BiasSliders sliders) throws CameraProblem {
    Map<String, Double> middle = values(biases);
    for (Slider slider : Slider.values()) {
      int moved = 0;
      sliders.set(slider, -1);
      Map<String, Double> left = values(biases);
      sliders.set(slider, 1);
      Map<String, Double> right = values(biases);
      Map<String, Double> before = left;
      for (int step = -STEPS; step <= STEPS; step++) {
        sliders.set(slider, (double) step / STEPS);
        Map<String, Double> now = values(biases);
        for (Parameter bias : biases.parameters()) {
          String name = bias.name();
          double direction = Math.signum(right.get(name) - left.get(name));
          double risen = now.get(name) - before.get(name);
          assertTrue(risen == 0 || Math.signum(risen) == direction, slider + " " + name);
          assertTrue(now.get(name) >= bias.min() && now.get(name) <= bias.max(), name);
          moved += risen == 0 ? 0 : 1;
        }
        before = now;
        if (step == 0) {
          assertEquals(middle, now);
        }
      }
      assertTrue(moved > 0, slider + " moves something");
      sliders.set(slider, 0);
      assertEquals(middle, values(biases));
    }
  }

  private static Map<String, Double> values(Biases biases) {
    Map<String, Double> values = new LinkedHashMap<>();
    biases.parameters().forEach(bias -> values.put(bias.name(), biases.get(bias.name())));
    return values;
  }
}
