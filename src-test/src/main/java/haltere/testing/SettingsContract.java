package haltere.testing;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.DynamicContainer.dynamicContainer;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import haltere.core.json.internal.Json;
import haltere.core.settings.Parameter;
import haltere.core.settings.SettingsJson;
import haltere.core.settings.SettingsProblem;
import haltere.core.settings.SettingsSchema;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicContainer;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/** Contract of every settings record. The test of a module extends it and names its records. */
public abstract class SettingsContract {
  private static final int MAX_COMPONENTS = 8;
  private static final int MAX_WORDS = 25;

  /**
   * The settings records to test.
   *
   * @return at least one
   */
  protected abstract Collection<? extends Class<? extends Record>> settingsTypes();

  /**
   * A tree of tests: a branch for each record, a leaf for each property of it.
   *
   * @return the tests
   */
  @TestFactory
  Stream<DynamicContainer> everySettingsRecordMeetsTheContract() {
    assertFalse(settingsTypes().isEmpty(), "there is no settings record to test");
    return settingsTypes().stream()
        .map(type -> dynamicContainer(type.getSimpleName(), tests(SettingsSchema.of(type))));
  }

  private static <S extends Record> List<DynamicTest> tests(SettingsSchema<S> schema) {
    List<DynamicTest> tests = new ArrayList<>();
    tests.add(
        dynamicTest(
            "a record and those nested in it have at most eight components each",
            () -> checkSize(schema.type())));
    tests.add(dynamicTest("JSON keeps every value", () -> checkJson(schema)));
    for (Parameter parameter : schema.parameters()) {
      String name = parameter.name();
      tests.add(dynamicTest(name + " is explained", () -> checkWords(parameter)));
      tests.add(
          dynamicTest(
              name + " has a valid default",
              () ->
                  assertEquals(
                      schema.defaults(),
                      schema.with(schema.defaults(), name, parameter.defaultValue()))));
      if (parameter.isNumber()) {
        tests.add(dynamicTest(name + " keeps to its range", () -> checkRange(schema, parameter)));
      } else if (!parameter.choices().isEmpty()) {
        tests.add(dynamicTest(name + " can be each choice", () -> checkChoices(schema, name)));
      }
    }
    return tests;
  }

  private static void checkSize(Class<?> type) {
    assertTrue(
        type.getRecordComponents().length <= MAX_COMPONENTS,
        () -> type.getSimpleName() + " has more than eight components: group them in records");
    for (var component : type.getRecordComponents()) {
      if (component.getType().isRecord()) {
        checkSize(component.getType());
      }
    }
  }

  private static void checkWords(Parameter parameter) {
    assertTrue(parameter.help().endsWith("."), "a sentence ends with a full stop");
    assertTrue(parameter.help().length() > 10, "the help says something");
    int words = parameter.help().split("\\s+").length;
    assertTrue(words <= MAX_WORDS, () -> words + " words: " + parameter.help());
    if (parameter.isNumber()) {
      assertFalse(parameter.unit().isBlank(), "a number has a unit, 1 for a ratio");
    }
  }

  private static <S extends Record> void checkJson(SettingsSchema<S> schema) throws Exception {
    S defaults = schema.defaults();
    assertEquals(defaults, throughJson(schema, defaults));
    for (Parameter parameter : schema.parameters()) {
      S changed = schema.with(defaults, parameter.name(), anotherValue(parameter));
      assertEquals(List.of(parameter.name()), schema.changed(changed));
      assertEquals(changed, throughJson(schema, changed));
    }
  }

  private static <S extends Record> S throughJson(SettingsSchema<S> schema, S settings)
      throws Exception {
    String text = Json.write(SettingsJson.toMap(settings, schema));
    return SettingsJson.fromMap((Map<?, ?>) Json.parse(text, "settings"), schema);
  }

  private static Object anotherValue(Parameter parameter) {
    Object value = parameter.defaultValue();
    if (parameter.isNumber()) {
      double number = ((Number) value).doubleValue();
      double other = number < parameter.max() ? parameter.max() : parameter.min();
      if (parameter.type() == double.class) {
        return number / 2 + other / 2;
      }
      return (long) other;
    }
    if (value instanceof Boolean flag) {
      return !flag;
    }
    if (value instanceof Enum<?> constant) {
      int next = (constant.ordinal() + 1) % parameter.choices().size();
      return parameter.choices().get(next);
    }
    return value + " and more";
  }

  private static <S extends Record> void checkRange(SettingsSchema<S> schema, Parameter parameter) {
    S defaults = schema.defaults();
    String name = parameter.name();
    double step = parameter.type() == double.class ? Math.ulp(parameter.max()) : 1;
    double lowStep = parameter.type() == double.class ? Math.ulp(parameter.min()) : 1;
    assertDoesNotThrow(() -> schema.with(defaults, name, parameter.min()));
    assertDoesNotThrow(() -> schema.with(defaults, name, parameter.max()));
    refused(schema, name, parameter.min() - lowStep);
    refused(schema, name, parameter.max() + step);
    refused(schema, name, Double.NaN);
    refused(schema, name, Double.POSITIVE_INFINITY);
    refused(schema, name, Double.NEGATIVE_INFINITY);
    refused(schema, name, "NaN");
    refused(schema, name, "much");
    refused(schema, name, null);
  }

  private static <S extends Record> void refused(
      SettingsSchema<S> schema, String name, Object value) {
    SettingsProblem problem =
        assertThrows(
            SettingsProblem.class,
            () -> schema.with(schema.defaults(), name, value),
            () -> name + " took " + value);
    assertTrue(problem.getMessage().contains(name), problem.getMessage());
  }

  private static <S extends Record> void checkChoices(SettingsSchema<S> schema, String name) {
    for (String choice : schema.parameter(name).choices()) {
      assertDoesNotThrow(() -> schema.with(schema.defaults(), name, choice));
    }
    refused(schema, name, "something else");
  }
}
