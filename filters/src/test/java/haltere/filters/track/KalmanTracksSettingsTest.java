package haltere.filters.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.settings.SettingsJson;
import haltere.core.settings.SettingsSchema;
import haltere.filters.cluster.ClusterTrackerSettings;
import haltere.testing.SettingsContract;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class KalmanTracksSettingsTest extends SettingsContract {
  private final SettingsSchema<KalmanTracksSettings> schema =
      SettingsSchema.of(KalmanTracksSettings.class);

  @Override
  protected Collection<? extends Class<? extends Record>> settingsTypes() {
    return List.of(KalmanTracksSettings.class);
  }

  @Test
  void originalPresetHasTheDefaultsOfCardinale() {
    KalmanTracksSettings original = new KalmanTracksFilter.Provider().presets().get("original");
    assertEquals(100, original.life().eventsTillTrack());
    assertEquals(TrackLifeSettings.EventCount.ALL_CLUSTERS, original.life().eventsOf());
    assertEquals(8, original.filter().maxMeasurementVariance());
    assertEquals(1, original.filter().minProcessVariance());
    assertEquals(TrackFilterSettings.Noise.PER_UPDATE, original.filter().noise());
    assertTrue(original.filter().dynamicVariances());
    assertEquals(5, original.road().view().bridgeHeightM());
    assertEquals(ClusterTrackerSettings.original(), original.clusters());
  }

  @Test
  void settingsOfEarlierVersionsAreReadWithAHintToTheReplacement() {
    List<String> notes = new ArrayList<>();
    KalmanTracksSettings read =
        SettingsJson.fromMap(
            Map.of(
                "updateIntervalUs", 5000,
                "things", Map.of("together", true),
                "measurement", Map.of("source", "outline", "eventsTillTrack", 9),
                "clusters", Map.of("output", Map.of("mostClusters", 12))),
            schema,
            notes::add);
    assertEquals(
        KalmanTracksSettings.defaults()
            .with(
                "life.trackIntervalUs=5000",
                "life.eventsTillTrack=9",
                "clusters.output.maxClusters=12"),
        read);
    assertTrue(notes.get(0).contains("left to object-tracker"), notes.get(0));
    assertTrue(notes.get(0).contains("measurement.source"), notes.get(0));
  }

  @Test
  void eachFormerNameLeadsToASettingOrASentence() {
    KalmanTracksSettings.formerNames()
        .forEach(
            (former, now) -> {
              boolean isSetting =
                  schema.parameters().stream().anyMatch(setting -> setting.name().equals(now));
              assertTrue(isSetting || now.contains(" "), former + " -> " + now);
            });
  }
}
