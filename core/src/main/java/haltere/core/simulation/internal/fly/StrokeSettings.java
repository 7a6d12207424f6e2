package haltere.core.simulation.internal.fly;

import haltere.core.settings.SettingsSchema;

/**
 * How the wings beat.
 *
 * @param beat settings that both wings share
 * @param left the left wing
 * @param right the right wing
 */
public record StrokeSettings(BeatSettings beat, WingStrokeSettings left, WingStrokeSettings right) {
  /** Checks the values. */
  public StrokeSettings {
    SettingsSchema.validate(StrokeSettings.class, beat, left, right);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static StrokeSettings defaults() {
    return new StrokeSettings(
        BeatSettings.defaults(),
        WingStrokeSettings.defaults(),
        new WingStrokeSettings(1.1, 1.72, 0.05, 0));
  }
}
