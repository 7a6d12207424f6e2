package haltere.filters.track;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;
import haltere.filters.cluster.ClusterTrackerSettings;
import java.util.List;

/**
 * Settings of {@link haltere.filters.track.kalman.TrackEstimator TrackEstimator}.
 *
 * @param clusters the cluster tracker below it
 * @param updateIntervalUs how often tracks look at their clusters
 * @param motion how tracks are expected to move
 * @param measurement what they take from their clusters
 * @param life how they begin and end
 * @param things which are of one thing
 * @param road the road that they are on, if they are on one
 */
public record KalmanTracksSettings(
    ClusterTrackerSettings clusters,
    @Help("Tracks take what their clusters have gathered in this time.")
        @Range(min = 1000, max = 1_000_000, logarithmic = true)
        @Unit("us")
        int updateIntervalUs,
    MotionSettings motion,
    MeasurementSettings measurement,
    LifeSettings life,
    ThingSettings things,
    RoadTracksSettings road) {
  /** Checks the ranges. */
  public KalmanTracksSettings {
    SettingsSchema.validate(
        KalmanTracksSettings.class,
        clusters,
        updateIntervalUs,
        motion,
        measurement,
        life,
        things,
        road);
  }

  /**
   * The settings to start from.
   *
   * @return those of each part, and 10 ms
   */
  public static KalmanTracksSettings defaults() {
    return new KalmanTracksSettings(
        ClusterTrackerSettings.defaults(),
        10_000,
        MotionSettings.defaults(),
        MeasurementSettings.defaults(),
        LifeSettings.defaults(),
        ThingSettings.defaults(),
        RoadTracksSettings.defaults());
  }

  /**
   * The filter of the original on today's cluster tracker, with its mathematics mended: one model
   * of constant velocity, the centre of the cluster as the measurement, 100 events of all clusters
   * together, variances that change with the age of a track, no feedback.
   *
   * @return the original's values
   */
  public static KalmanTracksSettings original() {
    return defaults()
        .with(
            "motion.model=straight",
            "motion.noise=per-update",
            "motion.minProcessVariance=1",
            "measurement.source=centre",
            "measurement.eventsTillTrack=100",
            "measurement.eventsOf=all-clusters",
            "measurement.dynamicVariances=true",
            "measurement.maxMeasurementVariance=8",
            "life.feedbackToCluster=false",
            "things.together=false",
            "things.standing=true");
  }

  /**
   * These settings but for some.
   *
   * @param assignments texts of the form {@code name=value}, such as {@code life.coastTimeS=1}
   * @return new settings
   * @throws haltere.core.settings.SettingsProblem for a name or a value that is not valid
   */
  public KalmanTracksSettings with(String... assignments) {
    return SettingsSchema.of(KalmanTracksSettings.class)
        .withAssignments(this, List.of(assignments));
  }

  /**
   * These settings with tracks on a road.
   *
   * @param view the road as the camera sees it
   * @return new settings
   */
  public KalmanTracksSettings onRoad(RoadTracksSettings view) {
    return new KalmanTracksSettings(
        clusters, updateIntervalUs, motion, measurement, life, things, view);
  }

  /**
   * These settings on other clusters.
   *
   * @param settings of the cluster tracker
   * @return new settings
   */
  public KalmanTracksSettings withClusters(ClusterTrackerSettings settings) {
    return new KalmanTracksSettings(
        settings, updateIntervalUs, motion, measurement, life, things, road);
  }

  /**
   * These settings with another rate of reports.
   *
   * @param rateHz reports a second of recording time, 0.001 to 100,000
   * @return new settings
   */
  public KalmanTracksSettings withReportRate(double rateHz) {
    return with("life.reportRateHz=" + rateHz);
  }
}
