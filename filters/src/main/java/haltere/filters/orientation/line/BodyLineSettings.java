package haltere.filters.orientation.line;

import haltere.core.settings.AdjustableSettings;
import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;
import java.util.Map;

/** Settings of {@link BodyLineFilter}. */
public record BodyLineSettings(
    @Help(
            value =
                "Lines are reported at this rate of recording time, while the body makes events.",
            label = "Report rate")
        @Range(min = 0.1, max = 100000, logarithmic = true)
        @Unit("Hz")
        double rateHz,
    @Help(
            value =
                "Events of a line for each pixel along the body's outline; a larger value averages"
                    + " for longer.",
            label = "Events per outline pixel")
        @Range(min = 0.1, max = 100, logarithmic = true)
        @Unit("1")
        double eventsPerOutlinePx,
    @Help(
            value = "Events within this many half axes of the body's centre are assigned to it.",
            label = "Gate")
        @Range(min = 1.1, max = 5)
        @Unit("1")
        double gateRadii,
    @Help(value = "A report needs this many new events.", label = "Minimum events")
        @Range(min = 1, max = 100000)
        @Unit("events")
        int minEvents,
    @Help(value = "Half axes of a body are at least this long.", label = "Minimum half axis")
        @Range(min = 0.5, max = 1000)
        @Unit("px")
        double minRadiusPx,
    @Help(value = "A body with a longer half axis is searched again.", label = "Maximum half axis")
        @Range(min = 2, max = 2000)
        @Unit("px")
        double maxRadiusPx,
    @Help(
            value = "A body without events for longer than this is searched again.",
            label = "Timeout")
        @Range(min = 1000, max = 1000000000, logarithmic = true)
        @Unit("us")
        long timeoutUs)
    implements AdjustableSettings<BodyLineSettings> {
  public BodyLineSettings {
    SettingsSchema.validate(
        BodyLineSettings.class,
        rateHz,
        eventsPerOutlinePx,
        gateRadii,
        minEvents,
        minRadiusPx,
        maxRadiusPx,
        timeoutUs);
  }

  static Map<String, String> formerNames() {
    return Map.of(
        "turns", "eventsPerOutlinePx",
        "leastEvents", "minEvents",
        "leastRadiusPx", "minRadiusPx",
        "greatestRadiusPx", "maxRadiusPx",
        "forgetUs", "timeoutUs");
  }

  /** {@return the default settings: an insect of 4 to 120 pixels} */
  public static BodyLineSettings defaults() {
    return new BodyLineSettings(200, 1, 1.6, 8, 1, 60, 200_000);
  }
}
