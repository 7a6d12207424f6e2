package haltere.filters.wing;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.Unit;

/** The weighted running average. */
public record RunningAverageSettings(
    @Help("Weight of an event in the average of its edge; a larger value smooths less.")
        @Range(min = 0.0001, max = 1, logarithmic = true)
        @Unit("1")
        double mixingFactor,
    @Help(
            "Time constant of the average; 0: each event has the weight of the mixing factor instead.")
        @Range(min = 0, max = 100_000)
        @Unit("us")
        int timeConstantUs,
    @Help("A wing has passed its centre at this share of its amplitude beyond it.")
        @Range(min = 0.01, max = 0.9)
        @Unit("1")
        double hysteresis,
    @Help(value = "Smallest hysteresis.", label = "Minimum hysteresis")
        @Range(min = 0, max = 1.5)
        @Unit("rad")
        double minHysteresisRad,
    @Help("Updates the body position after each beat.") boolean bodyUpdate,
    @Help("Updates the heading after each beat.") boolean headingUpdate) {}
