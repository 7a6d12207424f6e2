package haltere.ui.viewer.feature;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.file.Path;
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
}
