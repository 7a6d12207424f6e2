package haltere.filters.wing;

import haltere.core.settings.AdjustableSettings;
import haltere.core.settings.SettingsSchema;
import java.lang.reflect.RecordComponent;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Settings of {@link haltere.filters.wing.tracker.WingTracker WingTracker}.
 *
 * @param search search of the fly
 * @param position manual position of the fly
 * @param filter extended Kalman filter
 * @param noise noise of that filter
 * @param average running average
 * @param output rate and edges
 */
public record WingTrackerSettings(
    WingSearchSettings search,
    WingPositionSettings position,
    WingFilterSettings filter,
    WingNoiseSettings noise,
    RunningAverageSettings average,
    WingOutputSettings output)
    implements AdjustableSettings<WingTrackerSettings> {
  public WingTrackerSettings {
    SettingsSchema.validate(
        WingTrackerSettings.class, search, position, filter, noise, average, output);
  }

  /** {@return the default settings} */
  public static WingTrackerSettings defaults() {
    return new WingTrackerSettings(
        new WingSearchSettings(35_000, 400, 70, 400, 0),
        new WingPositionSettings(0, 0, 0, false, 0, 5, true, true),
        new WingFilterSettings(WingMethod.EKF, WingModel.WINGS, 4, 0, 50, 1, 4, true),
        new WingNoiseSettings(0.005, 0.02, 1e-4, 10, 4e4, 200, 4, 0),
        new RunningAverageSettings(0.1, 0, 0.33, 0.0873, false, false),
        new WingOutputSettings(1000, true, true, true, true));
  }

  /**
   * The wing tracker of Cardinale (2006) with its defaults: {@link WingModel#ORIGINAL}, started at
   * 240 Hz after 2000 events, R = 1000, no gate, hysteresis of 10 degrees, body and heading updated
   * at each beat. Two corrections: the fourth entry of its Jacobian is 0 (not a t cos xi), and the
   * innovation is that of the prediction.
   *
   * @return valid settings
   */
  public static WingTrackerSettings original() {
    return new WingTrackerSettings(
        new WingSearchSettings(35_000, 2000, 70, 400, 240),
        new WingPositionSettings(0, 0, 0, false, 0, 0, false, false),
        new WingFilterSettings(WingMethod.EKF, WingModel.ORIGINAL, 1, 0, 0, 1, 1000, false),
        new WingNoiseSettings(2, 1, 0.5, 2, 0, 0.001, 0, 1000),
        new RunningAverageSettings(0.1, 0, 0.01, 0.1745, true, true),
        defaults().output());
  }

  static Map<String, String> formerNames() {
    Map<String, String> names = new LinkedHashMap<>();
    for (RecordComponent component : WingPositionSettings.class.getRecordComponents()) {
      names.put("place." + component.getName(), "position." + component.getName());
    }
    names.put("search.leastEvents", "search.minEvents");
    names.put("search.leastFrequencyHz", "search.minFrequencyHz");
    names.put("search.mostFrequencyHz", "search.maxFrequencyHz");
    names.put("average.leastHysteresisRad", "average.minHysteresisRad");
    return names;
  }
}
