package haltere.filters.noise;

import haltere.core.chain.ConfigurableFilter;
import haltere.core.chain.NamedProvider;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;

/**
 * {@link Refractory} as a stage of a chain, and the template of a filter: settings in {@link
 * RefractorySettings}, algorithm in {@link Refractory}, and their adapter to a chain here.
 *
 * @since 0.1
 */
public final class RefractoryFilter implements ConfigurableFilter<RefractorySettings> {
  private final Refractory refractory;

  /**
   * A filter in its initial state.
   *
   * @param geometry of the sensor
   * @param settings of the filter
   */
  public RefractoryFilter(SensorGeometry geometry, RefractorySettings settings) {
    refractory = new Refractory(geometry, settings);
  }

  @Override
  public void process(EventPacket packet) {
    refractory.filter(packet);
  }

  @Override
  public void reset() {
    refractory.reset();
  }

  @Override
  public long memoryUs() {
    return settings().periodUs();
  }

  @Override
  public RefractorySettings settings() {
    return refractory.settings();
  }

  @Override
  public void apply(RefractorySettings settings) {
    refractory.apply(settings);
  }

  /** Creates the filter by its name in a chain. */
  public static final class Provider extends NamedProvider<RefractorySettings> {
    /** Called by the service loader. */
    public Provider() {
      super(
          "refractory",
          "Thins out bursts: passes an event if its pixel was silent before.",
          RefractorySettings.class,
          RefractoryFilter::new);
    }
  }
}
