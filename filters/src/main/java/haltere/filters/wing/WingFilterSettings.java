package haltere.filters.wing;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.Unit;

/** The extended Kalman filter. */
public record WingFilterSettings(
    @Help("Which method gives the estimates.") WingMethod method,
    @Help("A filter for each wing, for each edge, or the tracker of Cardinale (2006).")
        WingModel model,
    @Help("Harmonics of the stroke; 1 is a plain sinusoid.")
        @Range(min = 1, max = 4)
        @Unit("harmonics")
        int harmonics,
    @Help(
            "Constant delay of the camera from light to time stamp; a larger value makes estimates"
                + " of a later time.")
        @Range(min = 0, max = 2000)
        @Unit("us")
        double latencyUs,
    @Help("Events within this time go into one update; 0 makes an update for each event.")
        @Range(min = 0, max = 500)
        @Unit("us")
        int averagingUs,
    @Help("Events that each edge's filter averages before an update, with a filter for each edge.")
        @Range(min = 1, max = 1000, logarithmic = true)
        @Unit("events")
        int averagedEvents,
    @Help("Innovations beyond this many standard deviations are not taken in.")
        @Range(min = 2, max = 1000, logarithmic = true)
        @Unit("SD")
        double gateSd,
    @Help("Whether only the first of a pixel's events of one polarity in a row counts.")
        boolean firstOfRun) {}
