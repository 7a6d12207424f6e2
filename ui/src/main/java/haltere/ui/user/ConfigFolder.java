package haltere.ui.user;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;

/** The platform's folder for a user's settings. */
public final class ConfigFolder {
  /** System property that names another folder, for tests and for portable installations. */
  static final String PROPERTY = "haltere.config";

  private ConfigFolder() {}

  /** The folder of this user, which may not exist yet. */
  public static Path ofUser() {
    String chosen = System.getProperty(PROPERTY, "");
    return chosen.isEmpty()
        ? of(System.getProperty("os.name"), System.getProperty("user.home"), System.getenv())
        : Path.of(chosen);
  }

  /**
   * The folder on a platform, by its name as Java knows it, the user's home and the variables of
   * the environment.
   */
  static Path of(String system, String home, Map<String, String> environment) {
    String name = system.toLowerCase(Locale.ROOT);
    if (name.contains("win")) {
      String roaming = environment.getOrDefault("APPDATA", "");
      return (roaming.isEmpty() ? Path.of(home, "AppData", "Roaming") : Path.of(roaming))
          .resolve("Haltere");
    }
    if (name.contains("mac")) {
      return Path.of(home, "Library", "Application Support", "Haltere");
    }
    String config = environment.getOrDefault("XDG_CONFIG_HOME", "");
    return (config.isEmpty() ? Path.of(home, ".config") : Path.of(config)).resolve("haltere");
  }
}
