package haltere.core.simulation.internal.sensor;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/** The sensor of a scene. */
public record SensorSettings(
    @Help("Columns of the sensor.") @Range(min = 16, max = 2048) @Unit("px") int widthPx,
    @Help("Rows of the sensor.") @Range(min = 16, max = 2048) @Unit("px") int heightPx) {
  /** Checks the values. */
  public SensorSettings {
    SettingsSchema.validate(SensorSettings.class, widthPx, heightPx);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static SensorSettings defaults() {
    return new SensorSettings(128, 128);
  }
}
