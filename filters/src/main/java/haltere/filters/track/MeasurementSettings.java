package haltere.filters.track;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * What tracks take from their clusters, and how far they believe it. See {@code docs/tracking.md}.
 *
 * @param source what is measured
 * @param eventsTillTrack events until a track is launched or updated
 * @param eventsOf whose events these are
 * @param dynamicVariances whether the variances change with the age of a track
 * @param maxMeasurementVariance variance of a cluster's centre
 * @param rampTimeS how fast the variances change
 * @param varianceFactor by how much the scatter of events understates the variance of their mean
 * @param floorPx standard deviation of what no number of events averages out
 */
public record MeasurementSettings(
    @Help(
            "The middle of a round outline where there is one, the events' own mean, or the"
                + " cluster's centre as in the original.")
        MeasurementSource source,
    @Help("A track is launched, and then updated, when this many events have come in.")
        @Range(min = 1, max = 100_000, logarithmic = true)
        @Unit("events")
        int eventsTillTrack,
    @Help("Whether each cluster counts its own events, or all are counted together.")
        EventCount eventsOf,
    @Help(
            "While a track is young the measurement is believed more: the variance of a centre"
                + " rises to its end, the process noise falls from ten times its end.")
        boolean dynamicVariances,
    @Help("Variance of a cluster's centre where that is measured.")
        @Range(min = 1e-4, max = 1e6, logarithmic = true)
        @Unit("px^2")
        double maxMeasurementVariance,
    @Help("Dynamic variances go to their ends with this time constant.")
        @Range(min = 0.001, max = 100, logarithmic = true)
        @Unit("s")
        double rampTimeS,
    @Help("The variance of a mean of events is this many times what their scatter says.")
        @Range(min = 1, max = 1000, logarithmic = true)
        @Unit("1")
        double varianceFactor,
    @Help("Error of a mean of events that is left however many there are, standard deviation.")
        @Range(min = 0, max = 100)
        @Unit("px")
        double floorPx) {
  /** Checks the ranges. */
  public MeasurementSettings {
    SettingsSchema.validate(
        MeasurementSettings.class,
        source,
        eventsTillTrack,
        eventsOf,
        dynamicVariances,
        maxMeasurementVariance,
        rampTimeS,
        varianceFactor,
        floorPx);
  }

  /**
   * The settings to start from. The two variances are the original's.
   *
   * @return the outline or the events' own mean, at least 6 of them for each cluster
   */
  public static MeasurementSettings defaults() {
    return new MeasurementSettings(
        MeasurementSource.OUTLINE, 6, EventCount.EACH_CLUSTER, false, 8, 0.5, 1, 0.03);
  }
}
