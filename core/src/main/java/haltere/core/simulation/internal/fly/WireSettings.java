package haltere.core.simulation.internal.fly;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/** A straight dark wire in front of the fly, such as its tether. It is opaque. */
public record WireSettings(
    @Help("Width of the wire, 0 for none.") @Range(min = 0, max = 20) @Unit("px") double widthPx,
    @Help("Direction of the wire, counterclockwise from the x axis.")
        @Range(min = 0, max = 3.141592653589793)
        @Unit("rad")
        double angleRad,
    @Help("Distance of the wire from the middle of the sensor, to the left of its direction.")
        @Range(min = -1000, max = 1000)
        @Unit("px")
        double offsetPx) {
  /** Checks the values. */
  public WireSettings {
    SettingsSchema.validate(WireSettings.class, widthPx, angleRad, offsetPx);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static WireSettings defaults() {
    return new WireSettings(0, 0.6, 12);
  }
}
