package haltere.filters.selection;

import haltere.core.chain.ConfigurableFilter;
import haltere.core.chain.NamedProvider;
import haltere.core.event.EventPacket;

/** {@link PolaritySelection} as a stage of a chain. */
final class PolarityFilter implements ConfigurableFilter<PolaritySettings> {
  private final PolaritySelection polarity;

  /**
   * A filter in its initial state.
   *
   * @param settings of the filter
   */
  public PolarityFilter(PolaritySettings settings) {
    polarity = new PolaritySelection(settings);
  }

  @Override
  public void process(EventPacket packet) {
    polarity.filter(packet);
  }

  @Override
  public void reset() {
    // stateless
  }

  @Override
  public long memoryUs() {
    return 0;
  }

  @Override
  public PolaritySettings settings() {
    return polarity.settings();
  }

  @Override
  public void apply(PolaritySettings settings) {
    polarity.apply(settings);
  }

  /** Creates the filter by its name in a chain. */
  public static final class Provider extends NamedProvider<PolaritySettings> {
    /** Called by the service loader. */
    public Provider() {
      super(
          "polarity",
          "Passes the events of one polarity, or of both.",
          PolaritySettings.class,
          (geometry, settings) -> new PolarityFilter(settings));
    }
  }
}
