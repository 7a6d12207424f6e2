package haltere.filters;

import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.event.SensorGeometry;
import haltere.filters.noise.BackgroundActivitySettings;
import haltere.filters.wing.WingTrackerSettings;

/**
 * The default chains.
 *
 * @since 0.1
 */
public final class DefaultChain {
  /** A wing's edge passes neighbouring pixels within a millisecond; blurred ones within ten. */
  private static final int WING_CORRELATION_US = 10_000;

  /** Some ten estimates a wing beat, so that a plot of them shows the stroke. */
  private static final String ESTIMATES_RATE = "output.rateHz=2000";

  private DefaultChain() {}

  /**
   * The object tracker with its default settings; noise is part of its model.
   *
   * @param geometry the sensor
   * @return a new chain
   */
  public static FilterChain create(SensorGeometry geometry) {
    FilterChain chain = new FilterChain(geometry);
    chain.add(Filters.named("object-tracker"));
    return chain;
  }

  /**
   * For a tethered fly: noise filters first, then the wing tracker with {@value #ESTIMATES_RATE}.
   *
   * @param geometry the sensor
   * @return a new chain
   */
  public static FilterChain forFly(SensorGeometry geometry) {
    FilterChain chain = new FilterChain(geometry);
    chain.apply(
        chain.add(Filters.named("background-activity")),
        new BackgroundActivitySettings(WING_CORRELATION_US, 1, false));
    chain.add(Filters.named("hot-pixels"));
    ChainStage wings = chain.add(Filters.named("wing-tracker"));
    chain.apply(wings, WingTrackerSettings.defaults().with(ESTIMATES_RATE));
    return chain;
  }
}
