package haltere.device.model;

import haltere.core.settings.Parameter;
import java.util.List;

/**
 * A setting of a DAVIS camera and its address in the logic.
 *
 * @param parameter name, range, unit and help
 * @param module of the logic
 * @param number of the parameter in the module
 * @param scale steps of the logic for one unit
 */
record DavisSetting(Parameter parameter, int module, int number, double scale) {
  static DavisSetting flag(int module, int number, String name, String help, boolean defaultValue) {
    return new DavisSetting(Settings.flag(name, help, defaultValue), module, number, 1);
  }

  static DavisSetting number(
      int module, int number, String name, String help, String unit, int max, int defaultValue) {
    return scaled(module, number, name, help, unit, max, defaultValue, 1);
  }

  static DavisSetting scaled(
      int module,
      int number,
      String name,
      String help,
      String unit,
      int max,
      int defaultValue,
      double scale) {
    return new DavisSetting(
        new Parameter(name, int.class, unit, 0, max, max > 1000, help, defaultValue, List.of(), ""),
        module,
        number,
        scale);
  }

  /** Whether it switches a source of data on or off. */
  boolean isSwitch() {
    boolean inertial = module == DavisRegisters.INERTIAL && number >= 2 && number <= 4;
    boolean frames = module == DavisRegisters.FRAMES && number == 4;
    boolean input = module == DavisRegisters.INPUT && number == 0;
    boolean events = module == DavisRegisters.EVENTS && number == 3;
    return inertial || frames || input || events;
  }

  /** Register value of a value. */
  int register(Object value) {
    if (value instanceof Boolean on) {
      return on ? 1 : 0;
    }
    return (int) Math.round(((Number) value).doubleValue() * scale);
  }
}
