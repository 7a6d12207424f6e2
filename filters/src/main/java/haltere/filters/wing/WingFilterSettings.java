package haltere.filters.wing;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.Unit;

/** The extended Kalman filter. */
public record WingFilterSettings(
    @Help("Extended Kalman filter, weighted running average, or both.") WingMethod method,
    @Help("A filter for each wing or for each edge, or the tracker of Cardinale (2006).")
        WingModel model,
    @Help("Harmonics of the stroke; 1 is a sinusoid.") @Range(min = 1, max = 4) @Unit("harmonics")
        int harmonics,
    @Help(
            "Constant delay of the camera from light to time stamp; a larger value puts estimates"
                + " further ahead of the events.")
        @Range(min = 0, max = 2000)
        @Unit("us")
        double latencyUs,
    @Help("Events within this time share one update; 0: an update for each event.")
        @Range(min = 0, max = 500)
        @Unit("us")
        int averagingUs,
    @Help("Events that the filter of an edge averages before an update (model: edges).")
        @Range(min = 1, max = 1000, logarithmic = true)
        @Unit("events")
        int averagedEvents,
    @Help("Innovations beyond this many standard deviations are rejected.")
        @Range(min = 2, max = 1000, logarithmic = true)
        @Unit("SD")
        double gateSd,
    @Help(
            value = "Uses only the first of consecutive events of one polarity at a pixel.",
            label = "First event of a run only")
        boolean firstOfRun) {}
