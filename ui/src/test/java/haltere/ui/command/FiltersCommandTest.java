package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.FilterProvider;
import haltere.core.chain.Filters;
import haltere.core.settings.Parameter;
import org.junit.jupiter.api.Test;

class FiltersCommandTest {
  @Test
  void everyFilterIsListedWithItsSentenceAndAllItsSettings() {
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
  void aSettingIsShownWithRangeUnitAndDefault() {
    CommandRun run = CommandRun.of("filters", "refractory");
    assertTrue(run.out().contains("0 to 10000000 us [1000]"), run.out());
    assertFalse(run.out().contains("background-activity"), run.out());
    assertFalse(run.out().contains("presets"), run.out());
  }

  @Test
  void presetsAreNamed() {
    CommandRun run = CommandRun.of("filters", "kalman-tracks");
    assertTrue(run.out().contains("    presets: original"), run.out());
  }
}
