package haltere.core.chain;

/**
 * A filter with settings. They are a whole immutable record, swapped between two packets: a filter
 * never sees a half-changed set.
 *
 * @param <S> its settings record
 * @since 0.1
 */
public interface ConfigurableFilter<S extends Record> extends EventFilter {
  /**
   * The settings in force.
   *
   * @return an immutable record
   */
  S settings();

  /**
   * Takes new settings, keeping as much of its state as makes sense under them.
   *
   * @param settings a valid record
   */
  void apply(S settings);
}
