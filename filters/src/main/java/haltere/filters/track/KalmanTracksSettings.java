package haltere.filters.track;

import haltere.core.settings.AdjustableSettings;
import haltere.core.settings.SettingsSchema;
import haltere.filters.cluster.ClusterTrackerSettings;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Settings of {@link KalmanTracks}.
 *
 * @param clusters the cluster tracker below it
 * @param filter variances of the filters
 * @param life when tracks start, are updated and end
 * @param road the road that they are on, if they are on one
 */
public record KalmanTracksSettings(
    ClusterTrackerSettings clusters,
    TrackFilterSettings filter,
    TrackLifeSettings life,
    RoadTracksSettings road)
    implements AdjustableSettings<KalmanTracksSettings> {
  /** Checks the ranges. */
  public KalmanTracksSettings {
    SettingsSchema.validate(KalmanTracksSettings.class, clusters, filter, life, road);
  }

  /** {@return the default settings: those of each part} */
  public static KalmanTracksSettings defaults() {
    return new KalmanTracksSettings(
        ClusterTrackerSettings.defaults(),
        TrackFilterSettings.defaults(),
        TrackLifeSettings.defaults(),
        RoadTracksSettings.defaults());
  }

  /**
   * {@return the defaults of Cardinale (2006), on clusters with the defaults of that time: updates
   * after 100 events of all clusters, dynamic variances that end at 8 px² and at 1 per update, a
   * unit start covariance, no feedback, no coasting}
   */
  public static KalmanTracksSettings original() {
    return defaults()
        .withClusters(ClusterTrackerSettings.original())
        .with(
            "filter.noise=per-update",
            "filter.minProcessVariance=1",
            "filter.maxMeasurementVariance=8",
            "filter.dynamicVariances=true",
            "filter.launchSpeedPxS=1",
            "life.trackIntervalUs=1000",
            "life.eventsTillTrack=100",
            "life.eventsOf=all-clusters",
            "life.coastTimeS=0",
            "road.processVariance=1");
  }

  /**
   * {@return new settings, these with tracks on a road}
   *
   * @param view the road as the camera sees it
   */
  public KalmanTracksSettings onRoad(RoadTracksSettings view) {
    return new KalmanTracksSettings(clusters, filter, life, view);
  }

  /**
   * {@return new settings, these on other clusters}
   *
   * @param settings of the cluster tracker
   */
  public KalmanTracksSettings withClusters(ClusterTrackerSettings settings) {
    return new KalmanTracksSettings(settings, filter, life, road);
  }

  /** Names of settings of earlier versions, see {@link SettingsSchema}. */
  static Map<String, String> formerNames() {
    Map<String, String> names = new LinkedHashMap<>();
    names.put("updateIntervalUs", "life.trackIntervalUs");
    names.put("motion.noise", "filter.noise");
    names.put("motion.launchSpeedPxS", "filter.launchSpeedPxS");
    names.put("measurement.dynamicVariances", "filter.dynamicVariances");
    // settings of one of three motions, and of one of three measurements
    names.put("motion.minProcessVariance", "use filter.minProcessVariance");
    names.put("measurement.maxMeasurementVariance", "use filter.maxMeasurementVariance");
    names.put("measurement.eventsTillTrack", "life.eventsTillTrack");
    names.put("measurement.eventsOf", "life.eventsOf");
    names.put("measurement.rampTimeS", "use filter.varianceMixingFactor");
    names.put("life.reportRateHz", "clusters.output.reportRateHz");
    names.put("life.updatesTillShown", "use life.eventsTillTrack");
    names.put("life.mostTracks", "use clusters.output.maxClusters");
    names.put("life.pathS", "use clusters.output.pathPoints");
    // the other settings of these groups
    for (String name : List.of("motion", "measurement", "things", "life.restTimeS")) {
      names.put(name, "left to object-tracker");
    }
    names.put("road.lanes", "use the road file of track");
    names.put("road.countingLines", "use the road file of track");
    return names;
  }
}
