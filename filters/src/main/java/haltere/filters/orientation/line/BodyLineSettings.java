package haltere.filters.orientation.line;

import haltere.core.settings.AdjustableSettings;
import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/** Settings of {@link BodyLineFilter}. */
public record BodyLineSettings(
    @Help("Reports in a second of recording time; there is none while the body makes no events.")
        @Range(min = 0.1, max = 100000, logarithmic = true)
        @Unit("Hz")
        double rateHz,
    @Help("Events that a line is made of, as a multiple of the pixels along the body's outline.")
        @Range(min = 0.1, max = 100, logarithmic = true)
        @Unit("1")
        double turns,
    @Help("Events within so many half axes of the body's middle are its own.")
        @Range(min = 1.1, max = 5)
        @Unit("1")
        double gateRadii,
    @Help("A report needs so many new events.") @Range(min = 1, max = 100000) @Unit("events")
        int leastEvents,
    @Help("Smallest half axis of a body.") @Range(min = 0.5, max = 1000) @Unit("px")
        double leastRadiusPx,
    @Help("Largest half axis of a body; one that grows beyond is looked for anew.")
        @Range(min = 2, max = 2000)
        @Unit("px")
        double greatestRadiusPx,
    @Help("A body that makes no events for so long is looked for anew.")
        @Range(min = 1000, max = 1000000000, logarithmic = true)
        @Unit("us")
        long forgetUs)
    implements AdjustableSettings<BodyLineSettings> {
  public BodyLineSettings {
    SettingsSchema.validate(
        BodyLineSettings.class,
        rateHz,
        turns,
        gateRadii,
        leastEvents,
        leastRadiusPx,
        greatestRadiusPx,
        forgetUs);
  }

  /** {@return the settings to start from: an insect of 4 to 120 pixels} */
  public static BodyLineSettings defaults() {
    return new BodyLineSettings(200, 1, 1.6, 8, 1, 60, 200_000);
  }
}
