package haltere.core.simulation.internal.fly;

import haltere.core.settings.AdjustableSettings;
import haltere.core.settings.SettingsSchema;
import haltere.core.simulation.RunSettings;
import haltere.core.simulation.internal.sensor.NoiseSettings;
import haltere.core.simulation.internal.sensor.PhotoreceptorSettings;
import haltere.core.simulation.internal.sensor.PixelSettings;
import haltere.core.simulation.internal.sensor.SensorSettings;

/**
 * The tethered fly of {@link RenderedFlyScene}.
 *
 * @param sensor the sensor
 * @param fly the fly
 * @param stroke how its wings beat: the motion of their pitch axes
 * @param light the light behind it
 * @param pixel the pixels of the sensor
 * @param photoreceptor the low-pass of their light
 * @param noise background noise
 * @param run seed, start and length
 */
public record RenderedFlySceneSettings(
    SensorSettings sensor,
    RenderedFlySettings fly,
    StrokeSettings stroke,
    LightSettings light,
    PixelSettings pixel,
    PhotoreceptorSettings photoreceptor,
    NoiseSettings noise,
    RunSettings run)
    implements AdjustableSettings<RenderedFlySceneSettings> {
  /** Checks the values. */
  public RenderedFlySceneSettings {
    SettingsSchema.validate(
        RenderedFlySceneSettings.class,
        sensor,
        fly,
        stroke,
        light,
        pixel,
        photoreceptor,
        noise,
        run);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static RenderedFlySceneSettings defaults() {
    return new RenderedFlySceneSettings(
        SensorSettings.defaults(),
        RenderedFlySettings.defaults(),
        StrokeSettings.defaults(),
        LightSettings.defaults(),
        new PixelSettings(0.3, 0.04, 2000, 10, 5, 100, 0),
        PhotoreceptorSettings.defaults(),
        NoiseSettings.defaults(),
        RunSettings.defaults());
  }
}
