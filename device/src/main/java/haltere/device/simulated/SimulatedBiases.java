package haltere.device.simulated;

import haltere.core.camera.BiasSliders;
import haltere.core.camera.Biases;
import haltere.core.settings.Parameter;
import haltere.core.settings.SettingsProblem;
import haltere.core.settings.SettingsSchema;
import haltere.core.simulation.internal.sensor.NoiseSettings;
import haltere.core.simulation.internal.sensor.PixelSettings;
import haltere.core.simulation.internal.sensor.SensorTuning;
import haltere.core.simulation.internal.sensor.TunableScene;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;

/** The biases of a simulated camera: parameters of its pixels in physical units. */
final class SimulatedBiases implements Biases, BiasSliders {
  private static final List<String> NAMES =
      List.of(
          "threshold",
          "bandwidthHz",
          "refractoryUs",
          "latencyUs",
          "jitterUs",
          "busLimitEps",
          "leakHz",
          "shotHz");

  private final TunableScene<?> scene;
  private final SimulatedTransfers transfers;
  private final Map<String, Parameter> parameters = new LinkedHashMap<>();
  private final Map<String, SensorTuning> sets = new LinkedHashMap<>();
  private final Map<Slider, Double> sliders = new EnumMap<>(Slider.class);

  /** Tuning at the middle of the sliders; guarded by the transfers. */
  private SensorTuning middle;

  /**
   * Biases.
   *
   * @param scene is tuned
   * @param transfers guard the scene
   */
  SimulatedBiases(TunableScene<?> scene, SimulatedTransfers transfers) {
    this.scene = scene;
    this.transfers = transfers;
    middle = scene.tuning();
    List<Parameter> all =
        Stream.concat(
                SettingsSchema.of(PixelSettings.class).parameters().stream(),
                SettingsSchema.of(NoiseSettings.class).parameters().stream())
            .toList();
    for (String name : NAMES) {
      all.stream()
          .filter(parameter -> parameter.name().equals(name))
          .forEach(parameter -> parameters.put(name, parameter));
    }
    SensorTuning usual = middle;
    sets.put("default", usual);
    sets.put(
        "fast", usual.with("bandwidthHz", 10_000).with("latencyUs", 20).with("refractoryUs", 10));
    sets.put(
        "slow",
        usual
            .with("bandwidthHz", 300)
            .with("latencyUs", 400)
            .with("refractoryUs", 300)
            .with("shotHz", usual.noise().shotHz() / 4));
    for (Slider slider : Slider.values()) {
      sliders.put(slider, 0.0);
    }
  }

  @Override
  public List<Parameter> parameters() {
    return List.copyOf(parameters.values());
  }

  private Parameter parameter(String name) {
    Parameter parameter = parameters.get(name);
    if (parameter == null) {
      throw new IllegalArgumentException(
          "there is no bias named " + name + "; there are " + String.join(", ", NAMES));
    }
    return parameter;
  }

  @Override
  public double get(String name) {
    parameter(name);
    return transfers.read(() -> value(scene.tuning(), name));
  }

  private static double value(SensorTuning tuning, String name) {
    Object value =
        name.equals("leakHz") || name.equals("shotHz")
            ? SettingsSchema.of(NoiseSettings.class).get(tuning.noise(), name)
            : SettingsSchema.of(PixelSettings.class).get(tuning.pixel(), name);
    return ((Number) value).doubleValue();
  }

  @Override
  public void set(String name, double value) {
    parameter(name);
    transfers.change(
        () -> {
          SensorTuning wanted;
          try {
            wanted = scene.tuning().with(name, value);
          } catch (SettingsProblem outOfRange) {
            throw new IllegalArgumentException(outOfRange.getMessage(), outOfRange);
          }
          middle = new SensorTuning(wanted.pixel(), wanted.noise(), 0);
          double balance = sliders.get(Slider.BALANCE);
          sliders.replaceAll((slider, at) -> slider == Slider.BALANCE ? at : 0.0);
          scene.tune(new SensorTuning(middle.pixel(), middle.noise(), balance));
        });
  }

  @Override
  public List<String> sets() {
    return List.copyOf(sets.keySet());
  }

  @Override
  public void apply(String name) {
    SensorTuning set = sets.get(name);
    if (set == null) {
      throw new IllegalArgumentException(
          "there is no set of biases named "
              + name
              + "; there are "
              + String.join(", ", sets.keySet()));
    }
    transfers.change(
        () -> {
          middle = set;
          sliders.replaceAll((slider, at) -> 0.0);
          scene.tune(set);
        });
  }

  @Override
  public double get(Slider slider) {
    return transfers.read(() -> sliders.get(Objects.requireNonNull(slider, "slider")));
  }

  @Override
  public void set(Slider slider, double value) {
    if (!(value >= -1 && value <= 1)) {
      throw new IllegalArgumentException("a slider goes from -1 to 1, not to " + value);
    }
    transfers.change(
        () -> {
          sliders.put(slider, value);
          scene.tune(slid());
        });
  }

  /** Tuning by the sliders, relative to their middle. */
  private SensorTuning slid() {
    SensorTuning tuning = middle;
    tuning = scaled(tuning, "bandwidthHz", Math.pow(10, sliders.get(Slider.BANDWIDTH)));
    tuning = scaled(tuning, "shotHz", Math.pow(4, sliders.get(Slider.BANDWIDTH)));
    tuning = scaled(tuning, "threshold", Math.pow(3, sliders.get(Slider.THRESHOLD)));
    tuning = scaled(tuning, "refractoryUs", Math.pow(10, sliders.get(Slider.REFRACTORY_PERIOD)));
    return new SensorTuning(tuning.pixel(), tuning.noise(), sliders.get(Slider.BALANCE));
  }

  private SensorTuning scaled(SensorTuning tuning, String name, double factor) {
    Parameter parameter = parameter(name);
    double wanted = value(tuning, name) * factor;
    return tuning.with(name, Math.max(parameter.min(), Math.min(parameter.max(), wanted)));
  }

  /** All biases and sliders, a line each. */
  String text() {
    SensorTuning tuning = transfers.read(scene::tuning);
    StringBuilder text = new StringBuilder();
    for (Parameter parameter : parameters.values()) {
      text.append("bias." + parameter.name())
          .append(" = " + value(tuning, parameter.name()))
          .append(" " + parameter.unit() + "\n");
    }
    text.append("bias.balance = " + tuning.balance() + " 1\n");
    return text.toString();
  }
}
