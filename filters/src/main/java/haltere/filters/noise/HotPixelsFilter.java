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
   * @param geometry of the sensor
   * @param settings of the filter
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

  /** Hot pixels remain hot over a gap in the data. */
  @Override
  public boolean bridgesGaps() {
    return true;
  }

  @Override
  public long memoryUs() {
    // hot pixels are known after one complete period
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

  /** Creates the filter by its name in a chain. */
  public static final class Provider extends NamedProvider<HotPixelsSettings> {
    /** Called by the service loader. */
    public Provider() {
      super(
          "hot-pixels",
          "Detects pixels with an abnormal event rate and drops their events.",
          HotPixelsSettings.class,
          HotPixelsFilter::new);
    }
  }
}
