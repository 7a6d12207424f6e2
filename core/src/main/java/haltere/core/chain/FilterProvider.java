package haltere.core.chain;

import haltere.core.event.SensorGeometry;
import haltere.core.settings.SettingsProvider;

/**
 * Creates filters of one kind. Providers are found as services ({@code
 * META-INF/services/haltere.core.chain.FilterProvider}), so another jar can add one; see {@link
 * Filters}.
 *
 * @param <S> the settings record
 * @since 0.1
 */
public interface FilterProvider<S extends Record> extends SettingsProvider<S> {
  /**
   * A new filter.
   *
   * @param geometry the sensor whose events it will see
   * @param settings valid settings
   * @return a filter in its initial state
   */
  ConfigurableFilter<S> create(SensorGeometry geometry, S settings);

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
