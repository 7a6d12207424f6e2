package haltere.core.simulation.internal.sensor;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * The photoreceptor of a {@link PhotoreceptorArray}, beside the bandwidth of {@link PixelSettings},
 * which is that of its input node in the light of the background.
 *
 * @param followerHz cut-off of the source follower behind the logarithm, hertz; 0 for none, which
 *     leaves a pixel of first order
 */
public record PhotoreceptorSettings(
    @Help("Whether the bandwidth of the photoreceptor is proportional to the light on the pixel.")
        boolean followsLight,
    @Help("Cut-off frequency of the source follower behind the photoreceptor, 0 for none.")
        @Range(min = 0, max = 1000000, logarithmic = true)
        @Unit("Hz")
        double followerHz) {
  /** Checks the values. */
  public PhotoreceptorSettings {
    SettingsSchema.validate(PhotoreceptorSettings.class, followsLight, followerHz);
  }

  /**
   * The default settings.
   *
   * @return a bandwidth proportional to the light, no source follower
   */
  public static PhotoreceptorSettings defaults() {
    return new PhotoreceptorSettings(true, 0);
  }
}
