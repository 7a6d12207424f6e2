package haltere.core.chain;

import haltere.core.event.SensorGeometry;
import haltere.core.settings.SettingsSchema;
import java.util.Map;

/**
 * Makes filters of one kind. Providers are found as services ({@code
 * META-INF/services/haltere.core.chain.FilterProvider}), so another jar can add one; see {@link
 * Filters}.
 *
 * @param <S> the settings record
 * @since 0.1
 */
public interface FilterProvider<S extends Record> {
  /**
   * The name by which chains and the command line know the filter.
   *
   * @return lower case words joined by hyphens
   */
  String name();

  /**
   * What the filter does, in one sentence for a person.
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
   * A new filter.
   *
   * @param geometry the sensor whose events it will see
   * @param settings valid settings
   * @return a filter in its initial state
   */
  ConfigurableFilter<S> create(SensorGeometry geometry, S settings);

  /**
   * The schema of the settings.
   *
   * @return made from {@link #settingsType()}
   */
  default SettingsSchema<S> schema() {
    return SettingsSchema.of(settingsType());
  }

  /**
   * Settings to start from other than the defaults, such as those of the method that a filter goes
   * back to.
   *
   * @return valid settings by name, a lower case word; none unless a provider says otherwise
   */
  default Map<String, S> presets() {
    return Map.of();
  }

  /**
   * A new filter with the default settings.
   *
   * @param geometry the sensor whose events it will see
   * @return a filter in its initial state
   */
  default ConfigurableFilter<S> create(SensorGeometry geometry) {
    return create(geometry, schema().defaults());
  }
}
