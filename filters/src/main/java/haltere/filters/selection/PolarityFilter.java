package haltere.filters.selection;

import haltere.core.chain.ConfigurableFilter;
import haltere.core.chain.FilterProvider;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;

/** {@link PolaritySelection} as a stage of a chain. */
public final class PolarityFilter implements ConfigurableFilter<PolaritySettings> {
  private final PolaritySelection polarity;

  /**
   * A filter in its initial state.
   *
   * @param settings what to do
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
    // Nothing is remembered.
  }

  @Override
  public PolaritySettings settings() {
    return polarity.settings();
  }

  @Override
  public void apply(PolaritySettings settings) {
    polarity.apply(settings);
  }

  /** Makes the filter where its name is found in a chain. */
  public static final class Provider implements FilterProvider<PolaritySettings> {
    @Override
    public String name() {
      return "polarity";
    }

    @Override
    public String description() {
      return "Passes the events of one polarity, or of both.";
    }

    @Override
    public Class<PolaritySettings> settingsType() {
      return PolaritySettings.class;
    }

    @Override
    public PolarityFilter create(SensorGeometry geometry, PolaritySettings settings) {
      return new PolarityFilter(settings);
    }
  }
}
