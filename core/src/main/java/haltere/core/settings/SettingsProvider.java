package haltere.core.settings;

import java.util.Map;

/**
 * Creates objects of one named kind from settings, such as filters or scenes.
 *
 * @param <S> the settings record
 * @since 0.1
 */
public interface SettingsProvider<S extends Record> {
  /**
   * The name by which chains and the command line know it.
   *
   * @return lower case words joined by hyphens
   */
  String name();

  /**
   * Description in one sentence for users.
   *
   * @return ends with a full stop
   */
  String description();

  /**
   * The settings record.
   *
   * @return its class
   */
  Class<S> settingsType();

  /**
   * The schema of the settings.
   *
   * @return made from {@link #settingsType()}
   */
  default SettingsSchema<S> schema() {
    return SettingsSchema.of(settingsType());
  }

  /**
   * Other initial settings than the defaults, such as those of an original method.
   *
   * @return valid settings by name, a lower case word; none by default
   */
  default Map<String, S> presets() {
    return Map.of();
  }
}
