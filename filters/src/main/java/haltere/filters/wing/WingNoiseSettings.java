package haltere.filters.wing;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.Unit;

/**
 * Noise of the extended Kalman filter. Process noise is a spectral density; with {@link
 * WingModel#ORIGINAL} it is a variance added at each update.
 *
 * @param manoeuvre largest noise added to the frequency while the phase diverges; a filter of each
 *     edge, which does not detect that, always adds a twentieth of it
 */
public record WingNoiseSettings(
    @Help(value = "Process noise of the centre.", label = "Centre noise")
        @Range(min = 0, max = 1000, logarithmic = true)
        @Unit("rad^2/s")
        double centre,
    @Help(value = "Process noise of the amplitude.", label = "Amplitude noise")
        @Range(min = 0, max = 1000, logarithmic = true)
        @Unit("rad^2/s")
        double amplitude,
    @Help(value = "Process noise of the phase.", label = "Phase noise")
        @Range(min = 0, max = 1000, logarithmic = true)
        @Unit("rad^2/s")
        double phase,
    @Help(value = "Process noise of the frequency in steady flight.", label = "Frequency noise")
        @Range(min = 0, max = 1e6, logarithmic = true)
        @Unit("rad^2/s^3")
        double frequency,
    @Help(value = "Largest process noise added in a manoeuvre.", label = "Manoeuvre noise")
        @Range(min = 0, max = 1e6, logarithmic = true)
        @Unit("rad^2/s^3")
        double manoeuvre,
    @Help(value = "Standard deviation of the frequency's rate of change.", label = "Rate SD")
        @Range(min = 0.001, max = 1e5, logarithmic = true)
        @Unit("rad/s^2")
        double rateSd,
    @Help(value = "Process noise of the hinges.", label = "Hinge noise")
        @Range(min = 0, max = 1000, logarithmic = true)
        @Unit("px^2/s")
        double hingePx2PerS,
    @Help(value = "Variance of a measurement; 0: estimated.", label = "Measurement variance")
        @Range(min = 0, max = 1e5, logarithmic = true)
        @Unit("rad^2")
        double measurement) {}
