package haltere.core.chain;

/**
 * A filter with settings. These are one immutable record, replaced between two packets: a filter
 * never sees a partly changed set.
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
   * Applies new settings and keeps as much of the state as possible.
   *
   * @param settings a valid record
   */
  void apply(S settings);
}
