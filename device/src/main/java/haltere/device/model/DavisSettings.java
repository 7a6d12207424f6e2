package haltere.device.model;

import haltere.core.camera.CameraProblem;
import haltere.core.camera.Configuration;
import haltere.core.settings.Parameter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The settings of a DAVIS camera by module and parameter, and their values.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
final class DavisSettings implements Configuration {
  static final String EARLY_DELAY = "usb.maxDelayUs";

  /** USB counts delays in steps of 125 us. */
  static final int DELAY_STEP_US = 125;

  private static final int ACTIVITY_STEP_US = 250;

  private final DavisRegisters registers;
  private final DavisIdentity identity;
  private final DavisBiases biases;
  private final String head;
  private final Map<String, DavisSetting> settings = new LinkedHashMap<>();
  private final Map<String, Object> values = new LinkedHashMap<>();
  private boolean streaming;

  DavisSettings(DavisRegisters registers, DavisIdentity identity, DavisBiases biases, String head) {
    this.registers = registers;
    this.identity = identity;
    this.biases = biases;
    this.head = head;
    for (DavisSetting setting : all()) {
      settings.put(setting.parameter().name(), setting);
      values.put(setting.parameter().name(), setting.parameter().defaultValue());
    }
  }

  private List<DavisSetting> all() {
    List<DavisSetting> all = new ArrayList<>();
    int events = DavisRegisters.EVENTS;
    all.add(DavisSetting.flag(events, 3, "events.run", "Sends events.", true));
    all.add(
        DavisSetting.flag(
            events,
            4,
            "events.wait",
            "Pixels wait while USB is busy; off, events are lost instead.",
            false));
    if (identity.hasNoiseFilter()) {
      double perUs = 1.0 / ACTIVITY_STEP_US;
      all.add(
          DavisSetting.flag(
              events, 31, "noiseFilter.run", "Drops events without a neighbour.", true));
      all.add(
          DavisSetting.scaled(
              events,
              32,
              "noiseFilter.timeUs",
              "Longest time since a neighbour's event.",
              "us",
              1 << 20,
              2000,
              perUs));
      all.add(
          DavisSetting.flag(
              events,
              33,
              "refractoryFilter.run",
              "Suppresses events of a pixel for a time after each event.",
              false));
      all.add(
          DavisSetting.scaled(
              events,
              34,
              "refractoryFilter.timeUs",
              "Length of this refractory time.",
              "us",
              1 << 20,
              250,
              perUs));
    }
    frames(all);
    inertial(all);
    int input = DavisRegisters.INPUT;
    all.add(DavisSetting.flag(input, 0, "input.run", "Reports edges at the input.", true));
    all.add(DavisSetting.flag(input, 1, "input.rising", "Reports rising edges.", true));
    all.add(DavisSetting.flag(input, 2, "input.falling", "Reports falling edges.", true));
    all.add(DavisSetting.flag(input, 3, "input.pulses", "Reports pulses.", false));
    all.add(DavisSetting.flag(input, 4, "input.highPulses", "Pulses are high, not low.", true));
    all.add(
        DavisSetting.number(
            input, 5, "input.pulseCycles", "Shortest pulse.", "cycles", 1 << 20, 10));
    all.add(
        DavisSetting.scaled(
            DavisRegisters.USB,
            1,
            EARLY_DELAY,
            "Longest delay before a partial transfer is sent.",
            "us",
            DELAY_STEP_US * 1000,
            1000,
            identity.usbClockMhz()));
    return all;
  }

  private void frames(List<DavisSetting> all) {
    int frames = DavisRegisters.FRAMES;
    double clock = identity.adcClockMhz();
    all.add(DavisSetting.flag(frames, 4, "frames.run", "Sends frames.", true));
    all.add(DavisSetting.flag(frames, 5, "frames.wait", "Readout waits while USB is busy.", true));
    if (identity.hasGlobalShutter()) {
      all.add(
          DavisSetting.flag(
              frames, 7, "frames.globalShutter", "Exposes all pixels at once.", true));
    }
    all.add(
        DavisSetting.scaled(
            frames,
            12,
            "frames.exposureUs",
            "Exposure time of a frame.",
            "us",
            1_000_000,
            4000,
            clock));
    all.add(
        DavisSetting.scaled(
            frames,
            13,
            "frames.intervalUs",
            "Interval between frames.",
            "us",
            8_000_000,
            40_000,
            clock));
  }

  private static void inertial(List<DavisSetting> all) {
    int module = DavisRegisters.INERTIAL;
    all.add(DavisSetting.flag(module, 2, "inertial.acceleration", "Measures it.", true));
    all.add(DavisSetting.flag(module, 3, "inertial.rotation", "Measures it.", true));
    all.add(DavisSetting.flag(module, 4, "inertial.temperature", "Measures it.", true));
    all.add(
        DavisSetting.number(
            module, 5, "inertial.rateDivider", "Divider of the sample rate.", "1", 255, 0));
    all.add(
        DavisSetting.number(
            module, 6, "inertial.accelerationFilter", "Low pass, 0 fastest.", "1", 7, 1));
    all.add(
        DavisSetting.number(
            module, 7, "inertial.accelerationRange", "0 to 3: 2, 4, 8 and 16 g.", "1", 3, 1));
    all.add(
        DavisSetting.number(
            module, 9, "inertial.rotationFilter", "Low pass, 0 fastest.", "1", 7, 1));
    all.add(
        DavisSetting.number(
            module,
            10,
            "inertial.rotationRange",
            "0 to 3: 250, 500, 1000 and 2000 deg/s.",
            "1",
            3,
            1));
  }

  @Override
  public List<Parameter> parameters() {
    return settings.values().stream().map(DavisSetting::parameter).toList();
  }

  @Override
  public synchronized Object get(String name) {
    Settings.named(parameters(), name);
    return values.get(name);
  }

  @Override
  public synchronized void set(String name, Object value) throws CameraProblem {
    Object converted = Settings.named(parameters(), name).convert(value);
    DavisSetting setting = settings.get(name);
    if (streaming || !setting.isSwitch()) {
      registers.set(setting.module(), setting.number(), setting.register(converted));
    }
    values.put(name, converted);
  }

  /** Sends all settings except those that start data. */
  synchronized void send() throws CameraProblem {
    for (DavisSetting setting : settings.values()) {
      if (!setting.isSwitch()) {
        send(setting);
      }
    }
  }

  /** Starts or stops the data of the camera. */
  synchronized void setStreaming(boolean on) throws CameraProblem {
    streaming = on;
    for (DavisSetting setting : settings.values()) {
      if (setting.isSwitch()) {
        if (on) {
          send(setting);
        } else {
          registers.set(setting.module(), setting.number(), 0);
        }
      }
    }
  }

  private void send(DavisSetting setting) throws CameraProblem {
    registers.set(
        setting.module(),
        setting.number(),
        setting.register(values.get(setting.parameter().name())));
  }

  @Override
  public String text() {
    return Settings.text(head, this, biases);
  }
}
