package com.example.decimate;

import haltere.core.chain.ConfigurableFilter;
import haltere.core.chain.NamedProvider;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;

/** Passes every n-th event of the sensor. */
public final class DecimateFilter implements ConfigurableFilter<DecimateSettings> {
  private DecimateSettings settings;
  private int dropped;

  /**
   * A filter in its initial state.
   *
   * @param geometry the sensor, unused
   * @param settings the settings
   */
  public DecimateFilter(SensorGeometry geometry, DecimateSettings settings) {
    this.settings = settings;
  }

  @Override
  public void process(EventPacket packet) {
    int passed = 0;
    for (int i = 0; i < packet.size(); i++) {
      if (++dropped >= settings.keepEvery()) {
        dropped = 0;
        packet.move(i, passed++);
      }
    }
    packet.truncate(passed);
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

  /** Creates the filter by its name in a chain. */
  public static final class Provider extends NamedProvider<DecimateSettings> {
    /** For the service loader. */
    public Provider() {
      super(
          "decimate", "Passes every n-th event.", DecimateSettings.class, DecimateFilter::new);
    }
  }
}
