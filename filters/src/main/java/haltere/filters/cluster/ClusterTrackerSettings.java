package haltere.filters.cluster;

import haltere.core.settings.AdjustableSettings;
import haltere.core.settings.SettingsSchema;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Settings of {@link ClusterTracker}.
 *
 * @param shape a-priori shape
 * @param growth adaptation of the shape to the events
 * @param motion how events move a cluster, and its velocity
 * @param life support, visibility and death
 * @param merging which clusters merge
 * @param perspective how the size depends on the position
 * @param events which events count
 * @param output bounds and results
 */
public record ClusterTrackerSettings(
    ClusterShapeSettings shape,
    ClusterGrowthSettings growth,
    ClusterMotionSettings motion,
    ClusterLifeSettings life,
    ClusterMergingSettings merging,
    PerspectiveSettings perspective,
    ClusterEventSettings events,
    ClusterOutputSettings output)
    implements AdjustableSettings<ClusterTrackerSettings> {
  /** Checks the values. */
  public ClusterTrackerSettings {
    SettingsSchema.validate(
        ClusterTrackerSettings.class,
        shape,
        growth,
        motion,
        life,
        merging,
        perspective,
        events,
        output);
  }

  /** {@return the default settings: the defaults of all parts} */
  public static ClusterTrackerSettings defaults() {
    return new ClusterTrackerSettings(
        ClusterShapeSettings.defaults(),
        ClusterGrowthSettings.defaults(),
        ClusterMotionSettings.defaults(),
        ClusterLifeSettings.defaults(),
        ClusterMergingSettings.defaults(),
        PerspectiveSettings.defaults(),
        ClusterEventSettings.defaults(),
        ClusterOutputSettings.defaults());
  }

  /**
   * {@return the defaults of the tracker of Cardinale (2006): at most 10 clusters of 0.15 of the
   * longer side, a weight of 0.01, visible from 10 events on, dead after 10 ms, merging regardless
   * of direction}
   */
  public static ClusterTrackerSettings original() {
    return defaults()
        .with(
            "shape.size=0.15",
            "motion.mixingFactor=0.01",
            "motion.predict=false",
            "life.supportedBy=mass",
            "life.lifetimeUs=10000",
            "life.border=never",
            "merging.differentAngleDeg=180",
            "output.maxClusters=10");
  }

  /** Names of settings of earlier versions, see {@link SettingsSchema}. */
  static Map<String, String> formerNames() {
    String object = "left to object-tracker";
    Map<String, String> names = new LinkedHashMap<>();
    names.put("form.outline", "shape.type");
    for (String name : List.of("size", "aspect", "angleDeg", "angle")) {
      names.put("form." + name, "shape." + name);
    }
    names.put("growth.mostScale", "growth.maxScale");
    names.put("growth.events", "averaged with the weights of the location");
    names.put("motion.mixing", "use motion.weight, or object-tracker, which adapts");
    names.put("motion.longestMemoryUs", object);
    names.put("motion.velocity.timeUs", "motion.velocityTimeUs");
    names.put("motion.velocity.frictionTimeUs", "motion.frictionTimeUs");
    names.put("motion.velocity.start", "use motion.startVelocity");
    names.put("motion.velocity.neighbourRadii", "motion.neighbourRadii");
    names.put("life.birthEvents", "each event outside all clusters starts one");
    names.put("life.recentUs", "life.massTimeUs");
    names.put("life.visibleBy", "life.supportedBy");
    names.put("life.leastSpeedPxPerS", "life.minSpeedPxS");
    names.put("merging.seenTogetherUs", object);
    names.put("merging.seenApartUs", object);
    names.put("perspective.leastScale", "perspective.minScale");
    names.put("events.edges", object);
    names.put("output.mostClusters", "output.maxClusters");
    names.put("output.upkeepUs", "output.updateIntervalUs");
    return names;
  }
}
