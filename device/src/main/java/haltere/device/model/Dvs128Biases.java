package haltere.device.model;

import haltere.core.camera.BiasSliders;
import haltere.core.camera.Biases;
import haltere.core.camera.CameraProblem;
import haltere.core.settings.Parameter;
import haltere.device.model.SliderPositions.Effect;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The twelve biases of a DVS128: numbers of 24 bits, each a share of the master current (current =
 * master * value / 2^24), sent together in the order of the shift register, its far end first. The
 * sliders multiply some of them by a ratio; moving a slider starts from the values last set by name
 * or as a set.
 *
 * <p>Values of the sets: jAER's and libcaer's; see the wire facts in docs/cameras.md.
 */
final class Dvs128Biases implements Biases, BiasSliders {
  /** A bias: its position in the register, its effect, and its value in each set. */
  private enum Bias {
    CAS("cas", "Cascode of the photoreceptor.", 1992, 54, 54, 556),
    INJ_GND("injGnd", "Level of the differentiator's switch.", 1108364, 1108364, 1108364, 1108364),
    REQ_PD("reqPd", "Pull-down of the pixels' requests.", 16777215, 16777215, 16777215, 16777215),
    PU_X("puX", "Pull-up of the columns' requests.", 8159221, 8159221, 8159221, 8159221),
    DIFF_OFF(
        "diffOff",
        "Threshold of OFF events; a smaller value gives fewer events.",
        132,
        132,
        132,
        357),
    REQ("req", "Inverter of OFF requests.", 309590, 159147, 159147, 159147),
    REFR("refr", "Refractory period of a pixel; a larger value is shorter.", 969, 6, 6, 256),
    PU_Y("puY", "Pull-up of the rows' requests.", 16777215, 16777215, 16777215, 16777215),
    DIFF_ON(
        "diffOn",
        "Threshold of ON events; a larger value gives fewer events.",
        209996,
        482443,
        262144,
        177813),
    DIFF(
        "diff",
        "Differentiator, which both thresholds are compared with.",
        13125,
        30153,
        30153,
        8903),
    FOLL("foll", "Source follower between photoreceptor and differentiator.", 271, 51, 51, 2),
    PR("Pr", "Photoreceptor; a larger value is faster.", 217, 3, 3, 917);

    private final String label;
    private final String help;
    private final int[] inSets;

    Bias(String label, String help, int... inSets) {
      this.label = label;
      this.help = help;
      this.inSets = inSets;
    }
  }

  private static final List<String> SETS = List.of("fast", "slow", "standard", "jaer");
  private static final int MAX_BIAS = (1 << 24) - 1;
  private static final int BYTES = 3;
  private static final int REQUEST = 0xb8;

  /** Ratios of jAER's class for this chip. */
  private static final List<Effect> EFFECTS =
      List.of(
          new Effect(Slider.BANDWIDTH, Bias.FOLL.label, 300),
          new Effect(Slider.REFRACTORY_PERIOD, Bias.REFR.label, 1.0 / 300),
          new Effect(Slider.THRESHOLD, Bias.DIFF_ON.label, 100),
          new Effect(Slider.THRESHOLD, Bias.DIFF_OFF.label, 1.0 / 100),
          new Effect(Slider.BALANCE, Bias.DIFF.label, 100));

  private final ControlLine line;
  private final Map<String, Bias> byName = new LinkedHashMap<>();
  private SliderPositions sliders = SliderPositions.middle(EFFECTS);
  private int[] middle = set(0);

  Dvs128Biases(ControlLine line) {
    this.line = line;
    for (Bias bias : Bias.values()) {
      byName.put(bias.label, bias);
    }
  }

  private static int[] set(int index) {
    return Arrays.stream(Bias.values()).mapToInt(bias -> bias.inSets[index]).toArray();
  }

  @Override
  public List<Parameter> parameters() {
    List<Parameter> parameters = new ArrayList<>();
    for (Bias bias : Bias.values()) {
      parameters.add(
          new Parameter(
              bias.label,
              int.class,
              "2^-24",
              0,
              MAX_BIAS,
              true,
              bias.help,
              bias.inSets[0],
              List.of(),
              ""));
    }
    return parameters;
  }

  @Override
  public synchronized double get(String name) {
    return effective(middle, sliders)[bias(name).ordinal()];
  }

  @Override
  public synchronized void set(String name, double value) throws CameraProblem {
    Bias bias = bias(name);
    if (!(value >= 0 && value <= MAX_BIAS)) {
      throw new IllegalArgumentException(
          "bias " + name + " is " + value + ", it must be 0 to " + MAX_BIAS);
    }
    // biases set by name become the middle of the sliders
    int[] values = effective(middle, sliders);
    values[bias.ordinal()] = (int) Math.round(value);
    take(values);
  }

  @Override
  public List<String> sets() {
    return SETS;
  }

  @Override
  public synchronized void apply(String name) throws CameraProblem {
    int index = SETS.indexOf(name);
    if (index < 0) {
      throw new IllegalArgumentException(
          "there is no set of biases " + name + "; there are " + String.join(", ", SETS));
    }
    take(set(index));
  }

  private void take(int[] values) throws CameraProblem {
    send(values);
    middle = values;
    sliders = sliders.centred();
  }

  @Override
  public synchronized double get(Slider slider) {
    return sliders.at(slider);
  }

  @Override
  public synchronized void set(Slider slider, double value) throws CameraProblem {
    SliderPositions moved = sliders.with(slider, value);
    send(effective(middle, moved));
    sliders = moved;
  }

  /** Sends the values in effect. */
  synchronized void send() throws CameraProblem {
    send(effective(middle, sliders));
  }

  private void send(int[] values) throws CameraProblem {
    byte[] bytes = new byte[values.length * BYTES];
    for (int i = 0; i < values.length; i++) {
      bytes[i * BYTES] = (byte) (values[i] >> 16);
      bytes[i * BYTES + 1] = (byte) (values[i] >> 8);
      bytes[i * BYTES + 2] = (byte) values[i];
    }
    line.send(REQUEST, 0, 0, bytes);
  }

  private static int[] effective(int[] middle, SliderPositions sliders) {
    int[] values = middle.clone();
    for (Bias bias : Bias.values()) {
      double value = values[bias.ordinal()] * sliders.factor(bias.label);
      values[bias.ordinal()] = (int) Math.min(MAX_BIAS, Math.round(value));
    }
    return values;
  }

  private Bias bias(String name) {
    Bias bias = byName.get(name);
    if (bias == null) {
      throw new IllegalArgumentException(
          "there is no bias " + name + "; there are " + String.join(", ", byName.keySet()));
    }
    return bias;
  }
}
