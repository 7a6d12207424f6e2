package haltere.filters.object;

import haltere.core.settings.AdjustableSettings;
import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;
import java.util.Map;

/** Settings of {@link ObjectTrackerFilter}. */
public record ObjectTrackerSettings(
    @Help(
            value =
                "Usual size of an object; a larger value joins components over wider gaps. 0: the"
                    + " sizes of the components decide.",
            label = "Object size")
        @Range(min = 0, max = 2000)
        @Unit("px")
        double scalePx,
    @Help(
            value =
                "Observation time before an object is reported; a larger value separates and joins"
                    + " objects more reliably.",
            label = "Confirmation time")
        @Range(min = 0.1, max = 2)
        @Unit("s")
        double confirmS,
    @Help(
            value = "An object without events keeps its identity for this long.",
            label = "Coasting time")
        @Range(min = 0, max = 600)
        @Unit("s")
        double coastTimeS,
    @Help("Objects are reported at this rate of recording time.")
        @Range(min = 0.001, max = 100_000, logarithmic = true)
        @Unit("Hz")
        double reportRateHz,
    @Help(value = "The path of an object is drawn for this long.", label = "Path duration")
        @Range(min = 0, max = 60)
        @Unit("s")
        double pathS)
    implements AdjustableSettings<ObjectTrackerSettings> {
  /** Checks the ranges. */
  public ObjectTrackerSettings {
    SettingsSchema.validate(
        ObjectTrackerSettings.class, scalePx, confirmS, coastTimeS, reportRateHz, pathS);
  }

  static Map<String, String> formerNames() {
    return Map.of("rememberS", "coastTimeS");
  }

  /**
   * {@return the default settings: each object's own scale, reported after 0.3 s, coasting for 5 s,
   * 100 reports a second}
   */
  public static ObjectTrackerSettings defaults() {
    return new ObjectTrackerSettings(0, 0.3, 5, 100, 1);
  }
}
