package haltere.core.simulation.internal.flight;

import haltere.core.settings.AdjustableSettings;
import haltere.core.settings.SettingsSchema;
import haltere.core.simulation.RunSettings;
import haltere.core.simulation.internal.sensor.NoiseSettings;
import haltere.core.simulation.internal.sensor.SensorSettings;

/**
 * The free flight of {@link FlightScene}.
 *
 * @param sensor the sensor of each camera
 * @param body the body and how it flies
 * @param view the cameras around it
 * @param detection the detections and their errors
 * @param noise background noise
 * @param run seed, start and length
 */
public record FlightSettings(
    SensorSettings sensor,
    FlightBodySettings body,
    FlightViewSettings view,
    FlightDetectionSettings detection,
    NoiseSettings noise,
    RunSettings run)
    implements AdjustableSettings<FlightSettings> {
  /** Checks the values. */
  public FlightSettings {
    SettingsSchema.validate(FlightSettings.class, sensor, body, view, detection, noise, run);
  }

  /**
   * The default settings.
   *
   * @return a bumblebee and three cameras of 640 x 480 pixels
   */
  public static FlightSettings defaults() {
    return new FlightSettings(
        new SensorSettings(640, 480),
        FlightBodySettings.defaults(),
        FlightViewSettings.defaults(),
        FlightDetectionSettings.defaults(),
        new NoiseSettings(0.02, 0.1, 0.05, 3, 50),
        new RunSettings(1, 0, 0, 100));
  }
}
