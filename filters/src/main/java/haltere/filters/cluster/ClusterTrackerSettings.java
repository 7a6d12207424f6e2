package haltere.filters.cluster;

import haltere.core.settings.SettingsSchema;

/**
 * Settings of {@link ClusterTracker}.
 *
 * @param form which form clusters begin with
 * @param growth how they take on the size of what they follow
 * @param motion how events move them
 * @param life when there is one, when it is visible, when it is no more
 * @param merging which become one
 * @param perspective how their size depends on where they are
 * @param events which events count
 * @param output what is kept and told
 */
public record ClusterTrackerSettings(
    ClusterFormSettings form,
    ClusterGrowthSettings growth,
    ClusterMotionSettings motion,
    ClusterLifeSettings life,
    ClusterMergingSettings merging,
    PerspectiveSettings perspective,
    ClusterEventSettings events,
    ClusterOutputSettings output) {
  /** Checks the values. */
  public ClusterTrackerSettings {
    SettingsSchema.validate(
        ClusterTrackerSettings.class,
        form,
        growth,
        motion,
        life,
        merging,
        perspective,
        events,
        output);
  }

  /**
   * The settings to start from. They follow things of 2 to 80 pixels on a sensor of 128 x 128
   * pixels, and accordingly larger ones on a larger sensor, whatever their event rate is.
   *
   * @return the defaults of all parts
   */
  public static ClusterTrackerSettings defaults() {
    return new ClusterTrackerSettings(
        ClusterFormSettings.defaults(),
        ClusterGrowthSettings.defaults(),
        ClusterMotionSettings.defaults(),
        ClusterLifeSettings.defaults(),
        ClusterMergingSettings.defaults(),
        PerspectiveSettings.defaults(),
        ClusterEventSettings.defaults(),
        ClusterOutputSettings.defaults());
  }

  /**
   * These settings but for some.
   *
   * @param assignments texts of the form {@code name=value}, such as {@code form.size=0.1}
   * @return new settings
   * @throws haltere.core.settings.SettingsProblem for a name or a value that is not valid
   */
  public ClusterTrackerSettings with(String... assignments) {
    return SettingsSchema.of(ClusterTrackerSettings.class)
        .withAssignments(this, java.util.List.of(assignments));
  }
}
