package haltere.filters.wing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.settings.SettingsJson;
import haltere.core.settings.SettingsSchema;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Settings of the wing tracker in files. */
class WingTrackerSettingsTest {
  @Test
  void formerNamesOfPositionSettingsAreRead() {
    SettingsSchema<WingTrackerSettings> schema = SettingsSchema.of(WingTrackerSettings.class);
    List<String> notes = new ArrayList<>();
    WingTrackerSettings read =
        SettingsJson.fromMap(
            Map.of("place", Map.of("bodyOffsetXPx", 3.5, "flipHeading", true)), schema, notes::add);
    assertEquals(
        WingTrackerSettings.defaults()
            .with("position.bodyOffsetXPx=3.5", "position.flipHeading=true"),
        read);
    assertTrue(notes.get(0).contains("place.flipHeading -> position.flipHeading"), notes.get(0));
  }
}
