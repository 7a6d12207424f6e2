package haltere.core.settings;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import haltere.core.json.internal.Json;
import haltere.core.settings.SettingsSchemaTest.Band;
import haltere.core.settings.SettingsSchemaTest.Mood;
import haltere.core.settings.SettingsSchemaTest.Whole;
import java.util.Map;
import org.junit.jupiter.api.Test;

class SettingsJsonTest {
  private final SettingsSchema<Whole> schema = SettingsSchema.of(Whole.class);

  @Test
  void valuesOfAllTypesAreReadBack() throws Exception {
    Whole settings =
        new Whole(-3, 1_000_000_000_000L, true, Mood.VERY_BUSY, "\"ü\"\n", new Band(0.1, 1.0 / 3));
    String text = Json.write(SettingsJson.toMap(settings, schema));
    assertEquals(settings, SettingsJson.fromMap((Map<?, ?>) Json.parse(text, "a test"), schema));
  }

  @Test
  void nestedRecordsAreNestedObjectsInTheOrderOfTheRecord() {
    assertEquals(
        """
        {
          "count" : 1,
          "timeUs" : 1000,
          "on" : false,
          "mood" : "calm",
          "text" : "words",
          "band" : {
            "low" : 0.25,
            "high" : 0.75
          }
        }""",
        Json.write(SettingsJson.toMap(Whole.defaults(), schema)));
  }

  @Test
  void missingSettingsKeepTheirDefaults() {
    assertEquals(Whole.defaults(), SettingsJson.fromMap(Map.of(), schema));
    assertEquals(
        new Band(0.25, 0.5),
        SettingsJson.fromMap(Map.of("band", Map.of("high", 0.5)), schema).band());
  }

  @Test
  void onlyTheCombinationOfValuesMustBeValid() {
    assertEquals(
        new Band(0.8, 0.9),
        SettingsJson.fromMap(Map.of("band", Map.of("low", 0.8, "high", 0.9)), schema).band());
  }

  @Test
  void objectsAndValuesAtTheWrongPlaceAreRejected() {
    assertThrows(
        SettingsProblem.class, () -> SettingsJson.fromMap(Map.of("count", Map.of()), schema));
    assertThrows(
        SettingsProblem.class, () -> SettingsJson.fromMap(Map.of("count", Map.of("x", 1)), schema));
    assertThrows(SettingsProblem.class, () -> SettingsJson.fromMap(Map.of("band", 1), schema));
    assertThrows(
        SettingsProblem.class, () -> SettingsJson.fromMap(Map.of("bend", Map.of()), schema));
  }
}
