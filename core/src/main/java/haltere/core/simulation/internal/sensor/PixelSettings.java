package haltere.core.simulation.internal.sensor;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * The pixels of the sensor.
 *
 * @param busLimitEps events a second that the bus carries, 0 for no limit; events wait up to 1 ms
 *     and are lost then
 */
public record PixelSettings(
    @Help("Change of the natural logarithm of the light that triggers an event.")
        @Range(min = 0.01, max = 2, logarithmic = true)
        @Unit("ln")
        double threshold,
    @Help("Spread of the threshold over the pixels and their two polarities.")
        @Range(min = 0, max = 0.2)
        @Unit("ln")
        double thresholdSd,
    @Help(
            "Cut-off frequency of the photoreceptor, 0 for none; a low one sees the wing "
                + "at its reversals only.")
        @Range(min = 0, max = 1000000, logarithmic = true)
        @Unit("Hz")
        double bandwidthHz,
    @Help("Constant delay from the change to the time stamp.")
        @Range(min = 0, max = 2000)
        @Unit("us")
        double latencyUs,
    @Help("Standard deviation of that delay, which is never negative.")
        @Range(min = 0, max = 500)
        @Unit("us")
        double jitterUs,
    @Help("Refractory time after an event, in which the pixel is blind.")
        @Range(min = 0, max = 5000)
        @Unit("us")
        double refractoryUs,
    @Help(
            "Capacity of the bus in events per second, 0 for no limit; an event waits up "
                + "to 1 ms and is then lost.")
        @Range(min = 0, max = 100000000, logarithmic = true)
        @Unit("events/s")
        double busLimitEps) {
  /** Checks the values. */
  public PixelSettings {
    SettingsSchema.validate(
        PixelSettings.class,
        threshold,
        thresholdSd,
        bandwidthHz,
        latencyUs,
        jitterUs,
        refractoryUs,
        busLimitEps);
  }

  /**
   * The default settings.
   *
   * @return valid settings
   */
  public static PixelSettings defaults() {
    return new PixelSettings(0.2, 0.03, 3000, 60, 15, 30, 0);
  }
}
