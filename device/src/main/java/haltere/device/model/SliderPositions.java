package haltere.device.model;

import haltere.core.camera.BiasSliders.Slider;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * Positions of the sliders of a camera, and their effect on its biases: a slider at p, from −1
 * (left) to 1 (right), multiplies a bias by its ratio to the power of p. Law and ratios are those
 * of jAER.
 *
 * <p>Thread rule: immutable.
 */
final class SliderPositions {
  /**
   * The effect of a slider on a bias.
   *
   * @param slider the slider
   * @param bias its name
   * @param ratio above 0; below 1 if the bias decreases to the right
   */
  record Effect(Slider slider, String bias, double ratio) {}

  private final List<Effect> effects;
  private final Map<Slider, Double> positions;

  private SliderPositions(List<Effect> effects, Map<Slider, Double> positions) {
    this.effects = effects;
    this.positions = positions;
  }

  /** All sliders in the middle. */
  static SliderPositions middle(List<Effect> effects) {
    return new SliderPositions(effects, Map.of());
  }

  /** The same sliders, all in the middle. */
  SliderPositions centred() {
    return middle(effects);
  }

  double at(Slider slider) {
    return positions.getOrDefault(Objects.requireNonNull(slider, "slider"), 0.0);
  }

  /** The same positions with another one of a slider. */
  SliderPositions with(Slider slider, double position) {
    if (!(position >= -1 && position <= 1)) {
      throw new IllegalArgumentException("a slider stands at -1 to 1, not at " + position);
    }
    Map<Slider, Double> moved = new EnumMap<>(Slider.class);
    moved.putAll(positions);
    moved.put(Objects.requireNonNull(slider, "slider"), position);
    return new SliderPositions(effects, moved);
  }

  /** Factor of a bias; 1 if no slider affects it. */
  double factor(String bias) {
    double factor = 1;
    for (Effect effect : effects) {
      if (effect.bias.equals(bias)) {
        factor *= Math.pow(effect.ratio, at(effect.slider));
      }
    }
    return factor;
  }
}
