package com.example.decimate;

import haltere.core.chain.ConfigurableFilter;
import haltere.core.chain.NamedProvider;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;

/** Keeps one of so many events, whatever they are. */
public final class DecimateFilter implements ConfigurableFilter<DecimateSettings> {
  private DecimateSettings settings;
  private int dropped;

  /**
   * A filter in its initial state.
   *
   * @param geometry the sensor, which does not matter here
   * @param settings what to do
   */
  public DecimateFilter(SensorGeometry geometry, DecimateSettings settings) {
    this.settings = settings;
  }

  @Override
  public void process(EventPacket packet) {
    int kept = 0;
    for (int i = 0; i < packet.size(); i++) {
      if (++dropped >= settings.keepEvery()) {
        dropped = 0;
        packet.move(i, kept++);
      }
    }
    packet.truncate(kept);
  }

  @Override
  public void reset() {
    dropped = 0;
  }

  @Override
  public DecimateSettings settings() {
    return settings;
  }

  @Override
  public void apply(DecimateSettings newSettings) {
    settings = newSettings;
  }

  /** Makes the filter where its name is found in a chain. */
  public static final class Provider extends NamedProvider<DecimateSettings> {
    /** Found by its name in the list of services. */
    public Provider() {
      super(
          "decimate", "Keeps one of so many events.", DecimateSettings.class, DecimateFilter::new);
    }
  }
}
