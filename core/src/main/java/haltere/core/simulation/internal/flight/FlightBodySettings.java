package haltere.core.simulation.internal.flight;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/** The body of {@link FlightScene} and how it flies. */
public record FlightBodySettings(
    @Help("Length of the body, an ellipsoid.")
        @Range(min = 1e-4, max = 1, logarithmic = true)
        @Unit("m")
        double lengthM,
    @Help("Width of the body.") @Range(min = 1e-4, max = 1, logarithmic = true) @Unit("m")
        double widthM,
    @Help("Mean speed.") @Range(min = 0.001, max = 20, logarithmic = true) @Unit("m/s")
        double speedMS,
    @Help("Saccades per second.") @Range(min = 0, max = 5) @Unit("Hz") double saccadesPerS,
    @Help("Largest angle of a saccade.") @Range(min = 0, max = 120) @Unit("deg") double saccadeDeg,
    @Help("Duration of a saccade.") @Range(min = 0.02, max = 1, logarithmic = true) @Unit("s")
        double saccadeS,
    @Help("Mean angle of the head above the horizon.") @Range(min = -60, max = 60) @Unit("deg")
        double pitchDeg) {
  /** Checks the ranges. */
  public FlightBodySettings {
    SettingsSchema.validate(
        FlightBodySettings.class,
        lengthM,
        widthM,
        speedMS,
        saccadesPerS,
        saccadeDeg,
        saccadeS,
        pitchDeg);
  }

  /**
   * The default settings.
   *
   * @return a bumblebee that turns by up to 90 degrees in 70 ms
   */
  public static FlightBodySettings defaults() {
    return new FlightBodySettings(0.012, 0.004, 0.3, 1, 90, 0.07, 25);
  }
}
