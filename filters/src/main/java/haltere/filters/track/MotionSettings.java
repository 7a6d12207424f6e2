package haltere.filters.track;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * How tracks are expected to move in the picture. See {@code docs/tracking.md}.
 *
 * @param model what a track may do
 * @param noise how the process noise grows
 * @param minProcessVariance process noise of going straight on: for a density, px²/s³; per update,
 *     px² for places and px²/s² for velocities
 * @param turningVariance the same of turning
 * @param agileVariance the same of doing anything
 * @param turnVariance how fast the rate of turning changes
 * @param launchSpeedPxS standard deviation of the unknown velocity of a new track
 * @param meanStayS how long a track goes on in the same way, on average
 */
public record MotionSettings(
    @Help("Whether a track only goes straight on, or may turn and do anything as well.")
        MotionModel model,
    @Help("Process noise as a density per second, or the same at every update as in the original.")
        ProcessNoise noise,
    @Help("Process noise of a track that goes straight on (px^2 per update in the other form).")
        @Range(min = 0, max = 1e6, logarithmic = true)
        @Unit("px^2/s^3")
        double minProcessVariance,
    @Help("Process noise of a track that turns, beside the turning.")
        @Range(min = 0, max = 1e6, logarithmic = true)
        @Unit("px^2/s^3")
        double turningVariance,
    @Help("Process noise of a track that may do anything.")
        @Range(min = 0, max = 1e9, logarithmic = true)
        @Unit("px^2/s^3")
        double agileVariance,
    @Help("How fast the rate of turning changes.")
        @Range(min = 0, max = 1e4, logarithmic = true)
        @Unit("rad^2/s^3")
        double turnVariance,
    @Help("Standard deviation of the velocity of a new track, which nothing is known of.")
        @Range(min = 1, max = 1e5, logarithmic = true)
        @Unit("px/s")
        double launchSpeedPxS,
    @Help("A track keeps its way of moving for this long on average.")
        @Range(min = 0.01, max = 100, logarithmic = true)
        @Unit("s")
        double meanStayS) {
  /** Checks the ranges. */
  public MotionSettings {
    SettingsSchema.validate(
        MotionSettings.class,
        model,
        noise,
        minProcessVariance,
        turningVariance,
        agileVariance,
        turnVariance,
        launchSpeedPxS,
        meanStayS);
  }

  /**
   * The settings to start from.
   *
   * @return for things that mostly go straight or on circles
   */
  public static MotionSettings defaults() {
    return new MotionSettings(
        MotionModel.MANOEUVRING, ProcessNoise.DENSITY, 1.4, 10, 20_000, 1, 400, 6);
  }
}
