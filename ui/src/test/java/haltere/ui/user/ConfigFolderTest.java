package haltere.ui.user;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Where settings are kept. */
class ConfigFolderTest {
  @Test
  void configurationFolderDependsOnThePlatform() {
    Path home = Path.of("home");
    assertEquals(
        home.resolve(".config").resolve("haltere"), ConfigFolder.of("Linux", "home", Map.of()));
    assertEquals(
        Path.of("elsewhere", "haltere"),
        ConfigFolder.of("Linux", "home", Map.of("XDG_CONFIG_HOME", "elsewhere")));
    assertEquals(
        home.resolve("Library").resolve("Application Support").resolve("Haltere"),
        ConfigFolder.of("Mac OS X", "home", Map.of()));
    assertEquals(
        Path.of("roaming", "Haltere"),
        ConfigFolder.of("Windows 11", "home", Map.of("APPDATA", "roaming")));
  }
}
