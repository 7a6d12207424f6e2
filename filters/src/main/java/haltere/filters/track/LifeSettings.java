package haltere.filters.track;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * How tracks begin, go on without events and end.
 *
 * @param feedbackToCluster whether a cluster is put where its track expects it
 * @param updatesTillShown updates until a track is believed
 * @param gateSigmas how far from its expectation a track takes a measurement
 * @param coastTimeS how long a track goes on without its cluster
 * @param restTimeS how long the place is remembered where a track has stopped
 * @param mostTracks how many tracks there may be
 * @param reportRateHz how often the tracks are reported
 * @param pathS how long a piece of a track's way is drawn
 */
public record LifeSettings(
    @Help("Puts each cluster where its track expects it, so that it follows fast things.")
        boolean feedbackToCluster,
    @Help("A track is shown once it has been updated this many times.")
        @Range(min = 1, max = 1000, logarithmic = true)
        @Unit("updates")
        int updatesTillShown,
    @Help("A track takes no measurement that is farther than this from what it expects.")
        @Range(min = 1, max = 30)
        @Unit("sigma")
        double gateSigmas,
    @Help("A track without its cluster goes on for this long and takes a cluster that fits.")
        @Range(min = 0, max = 60)
        @Unit("s")
        double coastTimeS,
    @Help("Where a track has lost its events it is remembered for this long: it may have stopped.")
        @Range(min = 0, max = 600)
        @Unit("s")
        double restTimeS,
    @Help("There are no more tracks than this at a time.")
        @Range(min = 1, max = 500, logarithmic = true)
        @Unit("tracks")
        int mostTracks,
    @Help("The tracks are reported at this rate of recording time.")
        @Range(min = 0.001, max = 100_000, logarithmic = true)
        @Unit("Hz")
        double reportRateHz,
    @Help("The way of a track is drawn for this long.") @Range(min = 0, max = 60) @Unit("s")
        double pathS) {
  /** Checks the ranges. */
  public LifeSettings {
    SettingsSchema.validate(
        LifeSettings.class,
        feedbackToCluster,
        updatesTillShown,
        gateSigmas,
        coastTimeS,
        restTimeS,
        mostTracks,
        reportRateHz,
        pathS);
  }

  /**
   * The settings to start from.
   *
   * @return no feedback, shown at once, 100 reports a second
   */
  public static LifeSettings defaults() {
    return new LifeSettings(false, 1, 4, 0.4, 2, 100, 100, 1);
  }
}
