package haltere.core.settings;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Settings that were renamed or removed since an earlier version. */
class FormerNamesTest {
  record Outer(@Help("A switch.") boolean on, Inner inner) {
    Outer {
      SettingsSchema.validate(Outer.class, on, inner);
    }

    static Outer defaults() {
      return new Outer(false, new Inner(1));
    }

    static Map<String, String> formerNames() {
      return Map.of("enabled", "on", "group", "see docs/outer.md");
    }
  }

  record Inner(@Help("A number.") @Range(min = 0, max = 10) @Unit("px") int maxSizePx) {
    Inner {
      SettingsSchema.validate(Inner.class, maxSizePx);
    }

    static Inner defaults() {
      return new Inner(1);
    }

    static Map<String, String> formerNames() {
      return Map.of("mostPx", "maxSizePx", "leastPx", "no size is too small");
    }
  }

  private final SettingsSchema<Outer> schema = SettingsSchema.of(Outer.class);
  private final List<String> notes = new ArrayList<>();

  private Outer read(Map<String, Object> values) {
    return SettingsJson.fromMap(values, schema, notes::add);
  }

  @Test
  void valueOfAFormerNameIsAppliedWithAHintToTheNewName() {
    assertEquals(new Outer(true, new Inner(7)), read(Map.of("enabled", true, "inner", inner())));
    assertEquals(1, notes.size());
    assertTrue(notes.get(0).contains("inner.mostPx -> inner.maxSizePx"), notes.get(0));
    assertTrue(notes.get(0).contains("enabled -> on"), notes.get(0));
  }

  private static Map<String, Object> inner() {
    return Map.of("mostPx", 7);
  }

  @Test
  void removedSettingsAreSkippedWithAHintToTheReplacement() {
    Map<String, Object> values = Map.of("group", Map.of("a", 1), "inner", Map.of("leastPx", 2));
    assertEquals(Outer.defaults(), read(values));
    assertTrue(notes.get(0).contains("inner.leastPx -> no size is too small"), notes.get(0));
    assertTrue(notes.get(0).contains("group -> see docs/outer.md"), notes.get(0));
  }

  @Test
  void currentNamesGiveNoHint() {
    assertEquals(new Outer(true, new Inner(3)), read(Map.of("on", true, "inner", now())));
    assertEquals(List.of(), notes);
  }

  private static Map<String, Object> now() {
    return Map.of("maxSizePx", 3);
  }

  @Test
  void unknownNamesAreRejected() {
    assertThrows(SettingsProblem.class, () -> read(Map.of("off", true)));
  }

  @Test
  void assignmentToAFormerNameIsRejectedWithItsSuccessor() {
    assertEquals(
        "there is no setting inner.mostPx any more: inner.maxSizePx", problem("inner.mostPx=3"));
    assertEquals("there is no setting inner.mostPx any more: inner.maxSizePx", problem("mostPx=3"));
    assertEquals("there is no setting group.a any more: see docs/outer.md", problem("group.a=3"));
  }

  private String problem(String assignment) {
    return assertThrows(
            SettingsProblem.class,
            () -> schema.withAssignments(Outer.defaults(), List.of(assignment)))
        .getMessage();
  }
}
