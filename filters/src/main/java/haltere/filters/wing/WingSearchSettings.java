package haltere.filters.wing;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.Unit;

/** How the fly is searched for. */
public record WingSearchSettings(
    @Help("Length of the stretch of events that the fly is searched in.")
        @Range(min = 25_000, max = 100_000)
        @Unit("us")
        int windowUs,
    @Help("The search begins when it has this many events.")
        @Range(min = 100, max = 10_000, logarithmic = true)
        @Unit("events")
        int leastEvents,
    @Help("Slowest wing beat that is looked for.")
        @Range(min = 40, max = 400, logarithmic = true)
        @Unit("Hz")
        double leastFrequencyHz,
    @Help("Fastest wing beat that is looked for.")
        @Range(min = 100, max = 1000, logarithmic = true)
        @Unit("Hz")
        double mostFrequencyHz,
    @Help("Wing beat frequency if it is known, else 0: it is found then.")
        @Range(min = 0, max = 1000)
        @Unit("Hz")
        double startFrequencyHz) {}
