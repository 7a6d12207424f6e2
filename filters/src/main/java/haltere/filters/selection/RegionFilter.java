package haltere.filters.selection;

import haltere.core.chain.ConfigurableFilter;
import haltere.core.chain.NamedProvider;
import haltere.core.event.EventPacket;

/** {@link Region} as a stage of a chain. */
final class RegionFilter implements ConfigurableFilter<RegionSettings> {
  private final Region region;

  /**
   * A filter in its initial state.
   *
   * @param settings of the filter
   */
  public RegionFilter(RegionSettings settings) {
    region = new Region(settings);
  }

  @Override
  public void process(EventPacket packet) {
    region.filter(packet);
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
  public RegionSettings settings() {
    return region.settings();
  }

  @Override
  public void apply(RegionSettings settings) {
    region.apply(settings);
  }

  /** Creates the filter by its name in a chain. */
  public static final class Provider extends NamedProvider<RegionSettings> {
    /** Called by the service loader. */
    public Provider() {
      super(
          "region",
          "Passes the events inside, or those outside, of a rectangle.",
          RegionSettings.class,
          (geometry, settings) -> new RegionFilter(settings));
    }
  }
}
