package haltere.filters.track;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/** When tracks start, are updated and end. */
public record TrackLifeSettings(
    @Help("Least interval between updates of a track; updates coincide with those of its cluster.")
        @Range(min = 100, max = 1_000_000, logarithmic = true)
        @Unit("us")
        int trackIntervalUs,
    @Help(value = "Events until a track starts or is updated.", label = "Events per update")
        @Range(min = 1, max = 100_000, logarithmic = true)
        @Unit("events")
        int eventsTillTrack,
    @Help("Events are counted for each cluster, or for all clusters together.") EventCount eventsOf,
    @Help("Moves each cluster to the estimate of its track at each update.")
        boolean feedbackToCluster,
    @Help(
            "A track without a visible cluster continues for this time and accepts a new "
                + "one in its gate.")
        @Range(min = 0, max = 60)
        @Unit("s")
        double coastTimeS,
    @Help(
            "Gate: a track accepts a new cluster within this many standard deviations of "
                + "its prediction.")
        @Range(min = 1, max = 30)
        @Unit("sigma")
        double gateSigmas) {
  /** The events that count towards an update. */
  public enum EventCount {
    /** Each track waits for the events of its own cluster. */
    EACH_CLUSTER,
    /** All tracks are updated when all clusters together have the events: Cardinale (2006). */
    ALL_CLUSTERS
  }

  /** Checks the ranges. */
  public TrackLifeSettings {
    SettingsSchema.validate(
        TrackLifeSettings.class,
        trackIntervalUs,
        eventsTillTrack,
        eventsOf,
        feedbackToCluster,
        coastTimeS,
        gateSigmas);
  }

  /**
   * {@return the default settings: updates each 10 ms from 10 events on, no feedback, half a second
   * of coasting, 4 sigma}
   */
  public static TrackLifeSettings defaults() {
    return new TrackLifeSettings(10_000, 10, EventCount.EACH_CLUSTER, false, 0.5, 4);
  }
}
