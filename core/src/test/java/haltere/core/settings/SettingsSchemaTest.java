package haltere.core.settings;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class SettingsSchemaTest {
  enum Mood {
    CALM,
    VERY_BUSY
  }

  record Whole(
      @Help("A whole number.") @Range(min = -5, max = 10) @Unit("events") int count,
      @Help("A time.") @Range(min = 0, max = 1e12, logarithmic = true) @Unit("us") long timeUs,
      @Help("A switch.") boolean on,
      @Help("A choice.") Mood mood,
      @Help("A text.") String text,
      Band band) {
    Whole {
      SettingsSchema.validate(Whole.class, count, timeUs, on, mood, text, band);
    }

    static Whole defaults() {
      return new Whole(1, 1000, false, Mood.CALM, "words", new Band(0.25, 0.75));
    }
  }

  record Band(
      @Help("Its lower end.") @Range(min = 0, max = 1) @Unit("1") double low,
      @Help("Its upper end.") @Range(min = 0, max = 1) @Unit("1") double high) {
    Band {
      SettingsSchema.validate(Band.class, low, high);
      if (low > high) {
        throw new SettingsProblem("band.low must not be above band.high");
      }
    }
  }

  private final SettingsSchema<Whole> schema = SettingsSchema.of(Whole.class);
  private final Whole defaults = Whole.defaults();

  @Test
  void everyLeafIsAParameterInRecordOrder() {
    assertEquals(
        List.of("count", "timeUs", "on", "mood", "text", "band.low", "band.high"),
        schema.parameters().stream().map(Parameter::name).toList());
  }

  @Test
  void parametersStateTheirAnnotations() {
    Parameter time = schema.parameter("timeUs");
    assertEquals(long.class, time.type());
    assertEquals("us", time.unit());
    assertEquals(0, time.min());
    assertEquals(1e12, time.max());
    assertTrue(time.logarithmic() && time.isNumber());
    assertEquals("A time.", time.help());
    assertEquals(1000L, time.defaultValue());
    assertEquals("", time.group());
    assertEquals("band", schema.parameter("band.low").group());
    assertEquals(List.of("calm", "very-busy"), schema.parameter("mood").choices());
  }

  @Test
  void schemaOfAClassIsCached() {
    assertSame(schema, SettingsSchema.of(Whole.class));
  }

  @Test
  void changedValueGivesANewRecord() {
    Whole changed = schema.with(defaults, "band.low", 0.5);
    assertEquals(new Band(0.5, 0.75), changed.band());
    assertEquals(new Band(0.25, 0.75), defaults.band());
    assertEquals(List.of("band.low"), schema.changed(changed));
    assertEquals(0.5, schema.get(changed, "band.low"));
  }

  @Test
  void textsAreParsedAsTheTypeOfTheSetting() {
    Whole changed =
        schema.withAssignments(
            defaults,
            List.of("count=-5", "timeUs = 2.5e4", "on=true", "mood=very-busy", "text=a=b"));
    assertEquals(new Whole(-5, 25_000, true, Mood.VERY_BUSY, "a=b", new Band(0.25, 0.75)), changed);
  }

  @Test
  void severalValuesAreChangedAtOnceAndOnlyTheResultMustBeValid() {
    Map<String, Object> values = Map.of("band.low", 0.8, "band.high", 0.9);
    assertEquals(new Band(0.8, 0.9), schema.with(defaults, values).band());
    assertEquals(
        new Band(0.8, 0.9),
        schema.withAssignments(defaults, List.of("band.low=0.8", "band.high=0.9")).band());
    SettingsProblem problem =
        assertThrows(SettingsProblem.class, () -> schema.with(defaults, "band.low", 0.8));
    assertEquals("band.low must not be above band.high", problem.getMessage());
  }

  @Test
  void endsOfARangeAreValidAndValuesBeyondAreNot() {
    assertEquals(10, schema.with(defaults, "count", 10).count());
    assertEquals(-5, schema.with(defaults, "count", -5).count());
    assertProblem("setting count is 11, it must be -5 to 10 events", "count", 11);
    assertProblem("setting count is -6, it must be -5 to 10 events", "count", -6);
    assertProblem(
        "setting count is 9223372036854775808, it must be -5 to 10 events",
        "count",
        "9223372036854775808");
    assertProblem(
        "setting band.high is 1.0000000000000002, it must be 0 to 1",
        "band.high",
        Math.nextUp(1.0));
  }

  @Test
  void nanAndInfinitiesAreInvalid() {
    assertProblem("setting band.low is NaN, it must be 0 to 1", "band.low", Double.NaN);
    assertProblem(
        "setting band.low is Infinity, it must be 0 to 1", "band.low", Double.POSITIVE_INFINITY);
    assertProblem("setting count is NaN, it must be a whole number", "count", Double.NaN);
    assertThrows(SettingsProblem.class, () -> new Band(Double.NaN, 0.5));
    assertThrows(SettingsProblem.class, () -> new Band(0.5, Double.NaN));
  }

  @Test
  void valueOfTheWrongTypeIsRejected() {
    assertProblem("setting count is 1.5, it must be a whole number", "count", 1.5);
    assertProblem("setting count is many, it must be a whole number", "count", "many");
    assertProblem("setting on is yes, it must be true or false", "on", "yes");
    assertProblem("setting mood is sad, it must be one of calm, very-busy", "mood", "sad");
    assertProblem("setting text is null, it must be a text", "text", null);
    assertProblem("setting text is [1], it must be a text", "text", List.of(1));
  }

  @Test
  void constructorChecksValues() {
    SettingsProblem problem =
        assertThrows(
            SettingsProblem.class, () -> new Whole(11, 0, false, Mood.CALM, "", new Band(0, 1)));
    assertEquals("setting count is 11, it must be -5 to 10 events", problem.getMessage());
    assertThrows(SettingsProblem.class, () -> new Whole(1, 0, false, null, "", new Band(0, 1)));
    assertThrows(SettingsProblem.class, () -> new Whole(1, 0, false, Mood.CALM, "", null));
  }

  @Test
  void unknownNamesAreRejectedWithTheListOfNames() {
    assertProblem(
        "there is no setting size; there are"
            + " count, timeUs, on, mood, text, band.low, band.high",
        "size",
        1);
    SettingsProblem problem =
        assertThrows(
            SettingsProblem.class, () -> SettingsSchema.of(NoSettings.class).parameter("size"));
    assertEquals("there is no setting size, there are none here", problem.getMessage());
  }

  @Test
  void uniqueLastPartOfANameSuffices() {
    Whole changed = schema.withAssignments(defaults, List.of("low=0.5", "band.high=0.625"));
    assertEquals(new Band(0.5, 0.625), changed.band());
  }

  @Test
  void ambiguousLastPartIsReportedWithTheFullNames() {
    record Two(Band left, Band right) {
      Two {
        SettingsSchema.validate(Two.class, left, right);
      }

      static Two defaults() {
        return new Two(new Band(0, 1), new Band(0, 1));
      }
    }
    SettingsProblem problem =
        assertThrows(
            SettingsProblem.class,
            () -> SettingsSchema.of(Two.class).withAssignments(Two.defaults(), List.of("low=0.5")));
    assertEquals("several settings end in low: left.low, right.low", problem.getMessage());
  }

  @Test
  void assignmentNeedsANameAndAnEqualsSign() {
    for (String assignment : List.of("count", "=5", "")) {
      SettingsProblem problem =
          assertThrows(
              SettingsProblem.class, () -> schema.withAssignments(defaults, List.of(assignment)));
      assertEquals("\"" + assignment + "\" is not of the form name=value", problem.getMessage());
    }
  }

  @Test
  void incompleteSettingsRecordsAreProgrammingErrors() {
    record WithoutDefaults(@Help("A switch.") boolean on) {}
    record WithoutHelp(boolean on) {
      static WithoutHelp defaults() {
        return new WithoutHelp(true);
      }
    }
    record WithoutUnit(@Help("A number.") @Range(min = 0, max = 1) double x) {
      static WithoutUnit defaults() {
        return new WithoutUnit(0);
      }
    }
    record OfAnotherType(@Help("A number.") @Range(min = 0, max = 1) @Unit("1") float x) {
      static OfAnotherType defaults() {
        return new OfAnotherType(0);
      }
    }
    record WithBadDefaults(@Help("A number.") @Range(min = 0, max = 1) @Unit("1") double x) {
      WithBadDefaults {
        SettingsSchema.validate(WithBadDefaults.class, x);
      }

      static WithBadDefaults defaults() {
        return new WithBadDefaults(2);
      }
    }
    assertFault("has no static method defaults() without parameters", WithoutDefaults.class);
    assertFault("WithoutHelp.on needs @Help", WithoutHelp.class);
    assertFault("WithoutUnit.x needs @Help, @Range and @Unit", WithoutUnit.class);
    assertFault("OfAnotherType.x has the type float", OfAnotherType.class);
    assertFault("setting x is 2.0, it must be 0 to 1", WithBadDefaults.class);
  }

  private static void assertFault(String part, Class<? extends Record> type) {
    IllegalStateException fault =
        assertThrows(IllegalStateException.class, () -> SettingsSchema.of(type));
    assertTrue(fault.getMessage().contains(part), fault.getMessage());
  }

  private void assertProblem(String message, String name, Object value) {
    SettingsProblem problem =
        assertThrows(SettingsProblem.class, () -> schema.with(defaults, name, value));
    assertEquals(message, problem.getMessage());
  }
}
