package haltere.filters.wing;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.Unit;

/** The weighted running average. */
public record RunningAverageSettings(
    @Help("Each event moves its edge by this share of the difference.")
        @Range(min = 0.0001, max = 1, logarithmic = true)
        @Unit("1")
        double mixingFactor,
    @Help(
            "Time constant of the average, whatever the rate of the events; 0 weighs each event by the mixing factor.")
        @Range(min = 0, max = 100_000)
        @Unit("us")
        int timeConstantUs,
    @Help("A wing has passed its centre when it is this share of its amplitude past it.")
        @Range(min = 0.01, max = 0.9)
        @Unit("1")
        double hysteresis,
    @Help("Least hysteresis, whatever the amplitude.") @Range(min = 0, max = 1.5) @Unit("rad")
        double leastHysteresisRad,
    @Help("Whether the body follows the events after each beat.") boolean bodyUpdate,
    @Help("Whether the heading follows the events after each beat.") boolean headingUpdate) {}
