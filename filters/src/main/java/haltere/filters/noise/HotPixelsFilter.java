package haltere.filters.noise;

import haltere.core.chain.ConfigurableFilter;
import haltere.core.chain.NamedProvider;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;

/** {@link HotPixels} as a stage of a chain. */
final class HotPixelsFilter implements ConfigurableFilter<HotPixelsSettings> {
  private final HotPixels hotPixels;

  /**
   * A filter in its initial state.
   *
   * @param geometry the sensor whose events it will see
   * @param settings what to do
   */
  public HotPixelsFilter(SensorGeometry geometry, HotPixelsSettings settings) {
    hotPixels = new HotPixels(geometry, settings);
  }

  @Override
  public void process(EventPacket packet) {
    hotPixels.filter(packet);
  }

  @Override
  public void reset() {
    hotPixels.reset();
  }

  /** A gap in the data heals no pixel, so what has been learned outlives it. */
  @Override
  public boolean bridgesGaps() {
    return true;
  }

  @Override
  public long memoryUs() {
    // what is hot is known after one period that is whole
    return 2 * settings().periodUs();
  }

  @Override
  public HotPixelsSettings settings() {
    return hotPixels.settings();
  }

  @Override
  public void apply(HotPixelsSettings settings) {
    hotPixels.apply(settings);
  }

  /** Makes the filter where its name is found in a chain. */
  public static final class Provider extends NamedProvider<HotPixelsSettings> {
    /** Found by its name in the list of services. */
    public Provider() {
      super(
          "hot-pixels",
          "Detects pixels with an abnormal event rate and drops their events.",
          HotPixelsSettings.class,
          HotPixelsFilter::new);
    }
  }
}
