package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.FilterProvider;
import haltere.core.chain.Filters;
import haltere.core.json.JsonProblem;
import haltere.core.json.internal.Json;
import haltere.core.settings.Parameter;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class FiltersCommandTest {
  @Test
  void everyFilterIsListedWithDescriptionAndSettings() {
    CommandRun run = CommandRun.of("filters");
    assertEquals(0, run.status(), run.err());
    assertFalse(Filters.all().isEmpty());
    for (FilterProvider<?> filter : Filters.all().values()) {
      assertTrue(run.out().contains(filter.name() + "\n  " + filter.description()), run.out());
      for (Parameter parameter : filter.schema().parameters()) {
        assertTrue(
            run.out()
                .lines()
                .anyMatch(
                    line ->
                        line.startsWith("    " + parameter.name() + " ")
                            && line.contains("[")
                            && line.endsWith(parameter.help())),
            parameter.name());
      }
    }
  }

  @Test
  void settingsAreListedWithRangeUnitAndDefault() {
    CommandRun run = CommandRun.of("filters", "refractory");
    assertTrue(run.out().contains("0 to 10000000 us [1000]"), run.out());
    assertFalse(run.out().contains("background-activity"), run.out());
    assertFalse(run.out().contains("presets"), run.out());
  }

  @ParameterizedTest
  @ValueSource(strings = {"filters", "scenes"})
  void jsonListsSettingsWithRangeUnitAndDefault(String command) throws JsonProblem {
    CommandRun run = CommandRun.of(command, "--json");
    assertEquals(0, run.status(), run.err());
    Map<?, ?> all = (Map<?, ?>) Json.parse(run.out(), command);
    assertEquals(Set.of(command), all.keySet());
    for (Object entry : (List<?>) all.get(command)) {
      Map<?, ?> filter = (Map<?, ?>) entry;
      assertEquals(Set.of("name", "description", "settings", "presets"), filter.keySet());
      for (Object setting : (List<?>) filter.get("settings")) {
        Map<?, ?> keys = (Map<?, ?>) setting;
        assertTrue(keys.keySet().containsAll(Set.of("name", "default", "help")), keys.toString());
        assertEquals(keys.containsKey("min"), keys.containsKey("unit"), keys.toString());
      }
    }
  }

  @Test
  void jsonStatesRangesAndDefaultsAsNumbers() throws JsonProblem {
    CommandRun run = CommandRun.of("filters", "refractory", "--json");
    Map<?, ?> all = (Map<?, ?>) Json.parse(run.out(), "filters");
    Map<?, ?> filter = (Map<?, ?>) ((List<?>) all.get("filters")).get(0);
    Map<?, ?> setting = (Map<?, ?>) ((List<?>) filter.get("settings")).get(0);
    assertEquals(1000, ((Number) setting.get("default")).intValue());
    assertEquals(10_000_000, ((Number) setting.get("max")).intValue());
  }

  @Test
  void presetsAreListed() {
    CommandRun run = CommandRun.of("filters", "kalman-tracks");
    assertTrue(run.out().contains("    presets: original"), run.out());
  }
}
