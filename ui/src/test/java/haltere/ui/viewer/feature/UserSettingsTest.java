package haltere.ui.viewer.feature;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Settings in one file, of one window or of several. */
class UserSettingsTest {
  @TempDir Path folder;

  @Test
  void twoWindowsKeepWhatTheOtherOneHasSaved() throws IOException {
    UserSettings first = UserSettings.load(folder);
    UserSettings second = UserSettings.load(folder);
    first.put("theme", "light");
    first.save();
    second.put("gradient", "grey");
    second.save();
    assertFalse(second.hasChanged());
    UserSettings next = UserSettings.load(folder);
    assertEquals(Optional.of("light"), next.get("theme"));
    assertEquals(Optional.of("grey"), next.get("gradient"));
  }

  @Test
  void twoWindowsKeepEachOthersEntriesOfAMap() throws IOException {
    UserSettings before = UserSettings.load(folder);
    before.put("layouts", Map.of("a", 1L, "b", 1L, "c", 1L));
    before.save();
    UserSettings first = UserSettings.load(folder);
    UserSettings second = UserSettings.load(folder);
    first.put("layouts", Map.of("a", 2L, "b", 1L, "c", 1L, "first", 1L));
    first.save();
    second.put("layouts", Map.of("a", 1L, "c", 1L));
    second.put("layouts", Map.of("a", 1L, "c", 3L, "second", 1L));
    second.save();
    assertEquals(
        Map.of("a", 2L, "c", 3L, "first", 1L, "second", 1L),
        UserSettings.load(folder).map("layouts"));
  }
}
