package haltere.filters;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.settings.SettingsJson;
import haltere.core.settings.SettingsProblem;
import haltere.core.settings.SettingsSchema;
import haltere.filters.noise.HotPixelsSettings;
import haltere.filters.object.ObjectTrackerSettings;
import haltere.filters.orientation.OrientationSettings;
import haltere.filters.orientation.line.BodyLineSettings;
import haltere.filters.road.CountingLineSettings;
import haltere.filters.wing.WingTrackerSettings;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Files of earlier versions whose settings had other names. */
class FormerSettingNamesTest {
  private final List<String> notes = new ArrayList<>();

  private <S extends Record> S read(Class<S> type, Map<String, Object> values) {
    return SettingsJson.fromMap(values, SettingsSchema.of(type), notes::add);
  }

  private void assertNoted(String former, String present) {
    String note = former + " -> " + present;
    assertTrue(notes.stream().anyMatch(line -> line.contains(note)), note + " in " + notes);
  }

  @Test
  void formerNamesOfNoiseAndObjectSettingsAreRead() {
    assertEquals(
        12, read(HotPixelsSettings.class, Map.<String, Object>of("mostBlocked", 12)).maxBlocked());
    assertNoted("mostBlocked", "maxBlocked");
    assertEquals(
        7.5,
        read(ObjectTrackerSettings.class, Map.<String, Object>of("rememberS", 7.5)).coastTimeS());
    assertNoted("rememberS", "coastTimeS");
  }

  @Test
  void formerNamesOfWingSettingsAreRead() {
    Map<String, Object> search =
        Map.of("leastEvents", 500, "leastFrequencyHz", 80, "mostFrequencyHz", 300);
    Map<String, Object> average = Map.of("leastHysteresisRad", 0.2);
    assertEquals(
        WingTrackerSettings.defaults()
            .with(
                "search.minEvents=500",
                "search.minFrequencyHz=80",
                "search.maxFrequencyHz=300",
                "average.minHysteresisRad=0.2"),
        read(WingTrackerSettings.class, Map.of("search", search, "average", average)));
    assertNoted("search.mostFrequencyHz", "search.maxFrequencyHz");
  }

  @Test
  void formerNamesOfOrientationSettingsAreRead() {
    Map<String, Object> position = Map.of("togetherS", 0.03, "longestGapS", 2);
    Map<String, Object> direction = Map.of("doubtSigmas", 3, "certaintySigmas", 9);
    assertEquals(
        OrientationSettings.defaults()
            .with(
                "position.maxViewIntervalS=0.03",
                "position.maxGapS=2",
                "direction.exchangeSigmas=3",
                "direction.limitSigmas=9"),
        read(OrientationSettings.class, Map.of("position", position, "direction", direction)));
    assertNoted("direction.certaintySigmas", "direction.limitSigmas");
  }

  @Test
  void formerNamesOfBodyLineSettingsAreRead() {
    assertEquals(
        BodyLineSettings.defaults()
            .with(
                "eventsPerOutlinePx=2",
                "minEvents=9",
                "minRadiusPx=3",
                "maxRadiusPx=70",
                "timeoutUs=300000"),
        read(
            BodyLineSettings.class,
            Map.of(
                "turns", 2,
                "leastEvents", 9,
                "leastRadiusPx", 3,
                "greatestRadiusPx", 70,
                "forgetUs", 300_000)));
    assertNoted("turns", "eventsPerOutlinePx");
  }

  @Test
  void formerNameOfTheDistanceOfCountingLinesIsRead() {
    assertEquals(
        new CountingLineSettings(2, 20, 12),
        read(CountingLineSettings.class, Map.<String, Object>of("lines", 2, "apartM", 12)));
    assertNoted("apartM", "spacingM");
  }

  @Test
  void formerNameInAnAssignmentIsExplained() {
    SettingsProblem refused =
        assertThrows(
            SettingsProblem.class,
            () -> WingTrackerSettings.defaults().with("search.leastEvents=500"));
    assertTrue(refused.getMessage().contains("search.minEvents"), refused.getMessage());
  }
}
