package haltere.device.model;

import haltere.core.camera.BiasSliders;
import haltere.core.camera.Biases;
import haltere.core.camera.CameraProblem;
import haltere.core.settings.Parameter;
import haltere.device.model.SliderPositions.Effect;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;

/**
 * The biases of a DAVIS240 or DAVIS346 in physical units; with the manufacturer's defaults. The
 * sliders multiply some of them by a ratio; moving a slider starts from the values last set by name
 * or as a set.
 */
final class DavisBiases implements Biases, BiasSliders {
  private static final String DEFAULT = "default";
  private static final String P = "P";

  private static final List<DavisBias> DAVIS240 =
      List.of(
          DavisBias.current(0, "DiffBn", 4, 39),
          DavisBias.current(1, "OnBn", 5, 255),
          DavisBias.current(2, "OffBn", 4, 0),
          DavisBias.current(3, "ApsCasEpc", 5, 185, "cascode"),
          DavisBias.current(4, "DiffCasBnc", 5, 115, "cascode"),
          DavisBias.current(5, "ApsROSFBn", 6, 219),
          DavisBias.current(6, "LocalBufBn", 5, 164),
          DavisBias.current(7, "PixInvBn", 6, 144),
          DavisBias.current(8, "PrBp", 2, 58, P),
          DavisBias.current(9, "PrSFBp", 1, 16, P),
          DavisBias.current(10, "RefrBp", 4, 25, P),
          DavisBias.current(11, "AEPdBn", 6, 91),
          DavisBias.current(12, "LcolTimeoutBn", 5, 49),
          DavisBias.current(13, "AEPuXBp", 4, 80, P),
          DavisBias.current(14, "AEPuYBp", 7, 152, P),
          DavisBias.current(15, "IFThrBn", 5, 255),
          DavisBias.current(16, "IFRefrBn", 5, 255),
          DavisBias.current(17, "PadFollBn", 7, 215),
          DavisBias.current(18, "ApsOverflowLevelBn", 6, 253),
          DavisBias.current(19, "BiasBuffer", 5, 254),
          DavisBias.shiftedSource(20, "SSP"),
          DavisBias.shiftedSource(21, "SSN"));

  private static final List<DavisBias> DAVIS346 =
      List.of(
          DavisBias.voltage(0, "ApsOverflowLevel", 27, 6),
          DavisBias.voltage(1, "ApsCas", 21, 6),
          DavisBias.voltage(2, "AdcRefHigh", 32, 7),
          DavisBias.voltage(3, "AdcRefLow", 1, 7),
          DavisBias.voltage(4, "AdcTestVoltage", 21, 7),
          DavisBias.current(8, "LocalBufBn", 5, 164),
          DavisBias.current(9, "PadFollBn", 7, 215, "off"),
          DavisBias.current(10, "DiffBn", 4, 39),
          DavisBias.current(11, "OnBn", 5, 255),
          DavisBias.current(12, "OffBn", 4, 1),
          DavisBias.current(13, "PixInvBn", 6, 144),
          DavisBias.current(14, "PrBp", 2, 58, P),
          DavisBias.current(15, "PrSFBp", 1, 16, P),
          DavisBias.current(16, "RefrBp", 4, 25, P),
          DavisBias.current(17, "ReadoutBufBp", 6, 20, P),
          DavisBias.current(18, "ApsROSFBn", 6, 219),
          DavisBias.current(19, "AdcCompBp", 5, 20, P),
          DavisBias.current(20, "ColSelLowBn", 0, 1),
          DavisBias.current(21, "DACBufBp", 6, 60, P),
          DavisBias.current(22, "LcolTimeoutBn", 5, 49),
          DavisBias.current(23, "AEPdBn", 6, 91),
          DavisBias.current(24, "AEPuXBp", 4, 80, P),
          DavisBias.current(25, "AEPuYBp", 7, 152, P),
          DavisBias.current(26, "IFRefrBn", 5, 255),
          DavisBias.current(27, "IFThrBn", 5, 255),
          DavisBias.current(34, "BiasBuffer", 5, 254),
          DavisBias.shiftedSource(35, "SSP"),
          DavisBias.shiftedSource(36, "SSN"));

  /** Ratios of jAER's class for these chips. */
  private static final List<Effect> EFFECTS =
      List.of(
          new Effect(Slider.BANDWIDTH, "PrBp", 30),
          new Effect(Slider.BANDWIDTH, "PrSFBp", 30),
          new Effect(Slider.REFRACTORY_PERIOD, "RefrBp", 1.0 / 100),
          new Effect(Slider.THRESHOLD, "OnBn", 10),
          new Effect(Slider.THRESHOLD, "OffBn", 1.0 / 10),
          new Effect(Slider.BALANCE, "DiffBn", 10));

  private final DavisRegisters registers;
  private final Map<String, DavisBias> byName = new LinkedHashMap<>();

  /** Values at the middle of the sliders. */
  private final Map<String, Double> middle = new LinkedHashMap<>();

  private SliderPositions sliders = SliderPositions.middle(EFFECTS);

  DavisBiases(DavisRegisters registers, boolean isSmall) {
    this.registers = registers;
    for (DavisBias bias : isSmall ? DAVIS240 : DAVIS346) {
      byName.put(bias.name(), bias);
      middle.put(bias.name(), bias.defaultValue());
    }
  }

  @Override
  public List<Parameter> parameters() {
    return byName.values().stream().map(DavisBias::asParameter).toList();
  }

  @Override
  public synchronized double get(String name) {
    return effective(bias(name), sliders);
  }

  private double effective(DavisBias bias, SliderPositions positions) {
    double defaultValue = middle.get(bias.name());
    double factor = positions.factor(bias.name());
    return factor == 1 ? defaultValue : bias.nearest(Math.min(bias.max(), defaultValue * factor));
  }

  @Override
  public synchronized void set(String name, double value) throws CameraProblem {
    DavisBias bias = bias(name);
    double near = bias.nearest((Double) bias.asParameter().convert(value));
    send(bias, near);
    // biases set by name become the middle of the sliders
    middle.replaceAll((other, defaultValue) -> effective(bias(other), sliders));
    middle.put(name, near);
    sliders = sliders.centred();
  }

  private void send(DavisBias bias, double value) throws CameraProblem {
    registers.set(DavisRegisters.BIASES, bias.parameter(), bias.bits(value));
  }

  @Override
  public List<String> sets() {
    return List.of(DEFAULT);
  }

  @Override
  public synchronized void apply(String name) throws CameraProblem {
    if (!name.equals(DEFAULT)) {
      throw new IllegalArgumentException(
          "there is no set of biases " + name + "; there is " + DEFAULT);
    }
    change(DavisBias::defaultValue);
    middle.replaceAll((bias, value) -> bias(bias).defaultValue());
    sliders = sliders.centred();
  }

  @Override
  public synchronized double get(Slider slider) {
    return sliders.at(slider);
  }

  @Override
  public synchronized void set(Slider slider, double value) throws CameraProblem {
    SliderPositions moved = sliders.with(slider, value);
    change(bias -> effective(bias, moved));
    sliders = moved;
  }

  /** Sends changed values; if the camera refuses one, the previous values are sent again. */
  private void change(ToDoubleFunction<DavisBias> next) throws CameraProblem {
    List<DavisBias> sent = new ArrayList<>();
    try {
      for (DavisBias bias : byName.values()) {
        double value = next.applyAsDouble(bias);
        if (value != effective(bias, sliders)) {
          send(bias, value);
          sent.add(bias);
        }
      }
    } catch (CameraProblem problem) {
      restore(sent);
      throw problem;
    }
  }

  private void restore(List<DavisBias> sent) {
    for (DavisBias bias : sent) {
      try {
        send(bias, effective(bias, sliders));
      } catch (CameraProblem ignored) {
        return; // all biases are sent again after reconnection
      }
    }
  }

  /** Sends all values. */
  synchronized void send() throws CameraProblem {
    for (DavisBias bias : byName.values()) {
      send(bias, effective(bias, sliders));
    }
  }

  private DavisBias bias(String name) {
    DavisBias bias = byName.get(name);
    if (bias == null) {
      throw new IllegalArgumentException(
          "there is no bias " + name + "; there are " + String.join(", ", byName.keySet()));
    }
    return bias;
  }
}
