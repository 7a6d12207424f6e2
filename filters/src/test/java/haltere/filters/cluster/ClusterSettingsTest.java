package haltere.filters.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.settings.SettingsJson;
import haltere.core.settings.SettingsSchema;
import haltere.testing.SettingsContract;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class ClusterSettingsTest extends SettingsContract {
  private final SettingsSchema<ClusterTrackerSettings> schema =
      SettingsSchema.of(ClusterTrackerSettings.class);

  @Override
  protected Collection<? extends Class<? extends Record>> settingsTypes() {
    return List.of(ClusterTrackerSettings.class);
  }

  @Test
  void settingsOfEarlierVersionsAreReadWithAHintToTheReplacement() {
    List<String> notes = new ArrayList<>();
    ClusterTrackerSettings read =
        SettingsJson.fromMap(
            Map.of(
                "form", Map.of("size", 0.2, "outline", "box"),
                "motion", Map.of("mixing", "adaptive", "predict", false, "velocity", velocity()),
                "output", Map.of("mostClusters", 33)),
            schema,
            notes::add);
    assertEquals(
        ClusterTrackerSettings.defaults()
            .with(
                "shape.size=0.2",
                "shape.type=box",
                "motion.predict=false",
                "motion.velocityTimeUs=7000",
                "output.maxClusters=33"),
        read);
    assertEquals(1, notes.size());
    assertTrue(notes.get(0).contains("output.mostClusters -> output.maxClusters"), notes.get(0));
    assertTrue(notes.get(0).contains("motion.mixing -> use motion.weight"), notes.get(0));
  }

  private static Map<String, Object> velocity() {
    return Map.of("timeUs", 7000, "start", "events");
  }

  @Test
  void eachFormerNameLeadsToASettingOrASentence() {
    ClusterTrackerSettings.formerNames()
        .forEach(
            (former, now) -> {
              boolean isSetting =
                  schema.parameters().stream().anyMatch(setting -> setting.name().equals(now));
              assertTrue(isSetting || now.contains(" "), former + " -> " + now);
            });
  }
}
