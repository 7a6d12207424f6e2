package haltere.core.chain;

import haltere.core.event.SensorGeometry;
import java.util.function.BiFunction;

/**
 * A provider of one kind of filter by its name, a sentence and its constructor.
 *
 * @param <S> the settings record
 * @since 0.1
 */
public abstract class NamedProvider<S extends Record> implements FilterProvider<S> {
  private final String name;
  private final String description;
  private final Class<S> settingsType;
  private final BiFunction<SensorGeometry, S, ? extends ConfigurableFilter<S>> constructor;

  /**
   * A provider.
   *
   * @param name lower case words joined by hyphens
   * @param description of the filter, in one sentence for users
   * @param settingsType the settings record's class
   * @param constructor makes a filter in its initial state
   */
  protected NamedProvider(
      String name,
      String description,
      Class<S> settingsType,
      BiFunction<SensorGeometry, S, ? extends ConfigurableFilter<S>> constructor) {
    this.name = name;
    this.description = description;
    this.settingsType = settingsType;
    this.constructor = constructor;
  }

  @Override
  public final String name() {
    return name;
  }

  @Override
  public final String description() {
    return description;
  }

  @Override
  public final Class<S> settingsType() {
    return settingsType;
  }

  @Override
  public final ConfigurableFilter<S> create(SensorGeometry geometry, S settings) {
    return constructor.apply(geometry, settings);
  }
}
