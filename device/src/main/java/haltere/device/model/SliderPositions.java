package haltere.device.model;

import haltere.core.camera.BiasSliders.Slider;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * Where the sliders of a camera stand, and what that does to its biases: a slider at p multiplies a
 * bias by its ratio to the power of p, so by the whole ratio at the right end, by its inverse at
 * the left, and by nothing in the middle. That law, and the ratios, are those of jAER.
 *
 * <p>Thread rule: immutable.
 */
final class SliderPositions {
  /**
   * What a slider does to a bias.
   *
   * @param slider which
   * @param bias its name
   * @param ratio above 0; below 1 if the bias falls where the slider goes to the right
   */
  record Effect(Slider slider, String bias, double ratio) {}

  private final List<Effect> effects;
  private final Map<Slider, Double> positions;

  private SliderPositions(List<Effect> effects, Map<Slider, Double> positions) {
    this.effects = effects;
    this.positions = positions;
  }

  /** All in the middle. */
  static SliderPositions middle(List<Effect> effects) {
    return new SliderPositions(effects, Map.of());
  }

  /** All in the middle, of the same sliders. */
  SliderPositions centred() {
    return middle(effects);
  }

  double at(Slider slider) {
    return positions.getOrDefault(Objects.requireNonNull(slider, "slider"), 0.0);
  }

  /** The same with one slider elsewhere. */
  SliderPositions with(Slider slider, double position) {
    if (!(position >= -1 && position <= 1)) {
      throw new IllegalArgumentException("a slider stands at -1 to 1, not at " + position);
    }
    Map<Slider, Double> moved = new EnumMap<>(Slider.class);
    moved.putAll(positions);
    moved.put(Objects.requireNonNull(slider, "slider"), position);
    return new SliderPositions(effects, moved);
  }

  /** By how much a bias is multiplied; 1 if no slider moves it. */
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
