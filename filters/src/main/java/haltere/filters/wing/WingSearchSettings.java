package haltere.filters.wing;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.Unit;

/** Settings of the search for the fly. */
public record WingSearchSettings(
    @Help(value = "The fly is searched in the events of this duration.", label = "Search window")
        @Range(min = 25_000, max = 100_000)
        @Unit("us")
        int windowUs,
    @Help(value = "The search starts with this many events.", label = "Minimum events")
        @Range(min = 100, max = 10_000, logarithmic = true)
        @Unit("events")
        int minEvents,
    @Help(value = "Slower wing beats are not found.", label = "Minimum frequency")
        @Range(min = 40, max = 400, logarithmic = true)
        @Unit("Hz")
        double minFrequencyHz,
    @Help(value = "Faster wing beats are not found.", label = "Maximum frequency")
        @Range(min = 100, max = 1000, logarithmic = true)
        @Unit("Hz")
        double maxFrequencyHz,
    @Help(
            value = "Wing beat frequency, if it is known; 0: it is estimated.",
            label = "Known frequency")
        @Range(min = 0, max = 1000)
        @Unit("Hz")
        double startFrequencyHz) {}
