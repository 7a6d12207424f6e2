package haltere.filters.road;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;
import java.util.Map;

/** Lines across a road at which vehicles are counted, at equal distances. */
public record CountingLineSettings(
    @Help("Number of lines across the road at which vehicles are counted, 0 for none.")
        @Range(min = 0, max = 32)
        @Unit("lines")
        int lines,
    @Help("Distance of the nearest counting line along the road.")
        @Range(min = 0.1, max = 10_000, logarithmic = true)
        @Unit("m")
        double firstM,
    @Help("Distance from one counting line to the next.")
        @Range(min = 0.1, max = 10_000, logarithmic = true)
        @Unit("m")
        double spacingM) {
  /** Checks the ranges. */
  public CountingLineSettings {
    SettingsSchema.validate(CountingLineSettings.class, lines, firstM, spacingM);
  }

  static Map<String, String> formerNames() {
    return Map.of("apartM", "spacingM");
  }

  /** {@return the default settings: no lines; each 20 m once there are some} */
  public static CountingLineSettings defaults() {
    return new CountingLineSettings(0, 20, 20);
  }

  /**
   * {@return position of a line, metres along the road}
   *
   * @param line from 0
   */
  public double distanceM(int line) {
    return firstM + line * spacingM;
  }
}
