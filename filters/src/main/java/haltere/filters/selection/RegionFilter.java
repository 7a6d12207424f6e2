package haltere.filters.selection;

import haltere.core.chain.ConfigurableFilter;
import haltere.core.chain.FilterProvider;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;

/** {@link Region} as a stage of a chain. */
public final class RegionFilter implements ConfigurableFilter<RegionSettings> {
  private final Region region;

  /**
   * A filter in its initial state.
   *
   * @param settings what to do
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
    // Nothing is remembered.
  }

  @Override
  public RegionSettings settings() {
    return region.settings();
  }

  @Override
  public void apply(RegionSettings settings) {
    region.apply(settings);
  }

  /** Makes the filter where its name is found in a chain. */
  public static final class Provider implements FilterProvider<RegionSettings> {
    @Override
    public String name() {
      return "region";
    }

    @Override
    public String description() {
      return "Passes the events inside, or those outside, of a rectangle.";
    }

    @Override
    public Class<RegionSettings> settingsType() {
      return RegionSettings.class;
    }

    @Override
    public RegionFilter create(SensorGeometry geometry, RegionSettings settings) {
      return new RegionFilter(settings);
    }
  }
}
