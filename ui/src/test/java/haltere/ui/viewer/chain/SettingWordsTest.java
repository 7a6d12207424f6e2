package haltere.ui.viewer.chain;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.chain.FilterProvider;
import haltere.core.chain.Filters;
import haltere.core.settings.Parameter;
import haltere.ui.viewer.controls.Texts;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** What a person reads of the settings of filters. */
class SettingWordsTest {
  @Test
  void labelsOfAFilterAreUnique() {
    List<String> doubled = new ArrayList<>();
    for (FilterProvider<?> filter : Filters.all().values()) {
      Map<String, String> names = new HashMap<>();
      for (Parameter setting : filter.schema().parameters()) {
        String label = Texts.label(setting);
        String other = names.put(label, setting.name());
        if (other != null) {
          doubled.add(filter.name() + ": " + other + ", " + setting.name() + " = " + label);
        }
      }
    }
    assertEquals(List.of(), doubled);
  }

  @Test
  void helpOfASettingIsASentenceOfAtMost40Words() {
    List<String> others = new ArrayList<>();
    for (FilterProvider<?> filter : Filters.all().values()) {
      for (Parameter setting : filter.schema().parameters()) {
        String help = setting.help();
        if (!help.endsWith(".") || help.split(" ").length > 40) {
          others.add(filter.name() + " " + setting.name() + ": " + help);
        }
      }
    }
    assertEquals(List.of(), others);
  }

  @Test
  void limitsAreCalledMinimumAndMaximum() {
    assertEquals("Minimum events", label("body-line", "minEvents"));
    assertEquals("Maximum half axis", label("body-line", "maxRadiusPx"));
    assertEquals("Maximum frequency", label("wing-tracker", "search.maxFrequencyHz"));
    assertEquals("Minimum rate", label("hot-pixels", "rateHz"));
    assertEquals("Maximum clusters", label("cluster-tracker", "output.maxClusters"));
  }

  private static String label(String filter, String setting) {
    return Texts.label(Filters.named(filter).schema().parameter(setting));
  }
}
