package haltere.filters.wing;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.Unit;

/**
 * Noise of the extended Kalman filter. Process noise is a density per second, or, with {@link
 * WingModel#ORIGINAL}, what is added at each update.
 *
 * @param manoeuvre most that is added to it while the phase runs away; a filter of each edge, which
 *     does not notice that, always has a twentieth of it
 */
public record WingNoiseSettings(
    @Help("Process noise of the centre.")
        @Range(min = 0, max = 1000, logarithmic = true)
        @Unit("rad^2/s")
        double centre,
    @Help("Process noise of the amplitude.")
        @Range(min = 0, max = 1000, logarithmic = true)
        @Unit("rad^2/s")
        double amplitude,
    @Help("Process noise of the phase.")
        @Range(min = 0, max = 1000, logarithmic = true)
        @Unit("rad^2/s")
        double phase,
    @Help("Process noise of the angular frequency in steady flight.")
        @Range(min = 0, max = 1e6, logarithmic = true)
        @Unit("rad^2/s^3")
        double frequency,
    @Help("Most that is added to it in a manoeuvre, as the phase runs away from what is expected.")
        @Range(min = 0, max = 1e6, logarithmic = true)
        @Unit("rad^2/s^3")
        double manoeuvre,
    @Help("Standard deviation of the rate at which the angular frequency changes.")
        @Range(min = 0.001, max = 1e5, logarithmic = true)
        @Unit("rad/s^2")
        double rateSd,
    @Help("How the hinges wander.") @Range(min = 0, max = 1000, logarithmic = true) @Unit("px^2/s")
        double hingePx2PerS,
    @Help("Variance of a measurement; 0 learns it from the events.")
        @Range(min = 0, max = 1e5, logarithmic = true)
        @Unit("rad^2")
        double measurement) {}
