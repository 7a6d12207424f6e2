package haltere.filters.noise;

import haltere.core.chain.NamedProvider;
import haltere.core.chain.Outlet;
import haltere.core.chain.PublishingFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;

/**
 * {@link BackgroundActivity} as a stage of a chain. Publishes {@code shares}: a {@link
 * BackgroundActivityShare} after each window of 100 ms in which there were events.
 *
 * <p>Thread rule: as {@link haltere.core.chain.EventFilter}.
 */
final class BackgroundActivityFilter extends PublishingFilter<BackgroundActivitySettings> {
  private final Outlet<BackgroundActivityShare> shares =
      outlet("shares", BackgroundActivityShare.class);
  private final BackgroundActivity activity;

  /**
   * A filter in its initial state.
   *
   * @param geometry of the sensor
   * @param settings of the filter
   */
  public BackgroundActivityFilter(SensorGeometry geometry, BackgroundActivitySettings settings) {
    activity = new BackgroundActivity(geometry, settings, shares::publish);
  }

  @Override
  public void process(EventPacket packet) {
    activity.filter(packet);
  }

  @Override
  public void reset() {
    activity.reset();
  }

  @Override
  public long memoryUs() {
    return settings().isAutomatic() ? SupportTime.SETTLING_US : settings().correlationUs();
  }

  @Override
  public BackgroundActivitySettings settings() {
    return activity.settings();
  }

  @Override
  public void apply(BackgroundActivitySettings settings) {
    activity.apply(settings);
  }

  /** Creates the filter by its name in a chain. */
  public static final class Provider extends NamedProvider<BackgroundActivitySettings> {
    /** Called by the service loader. */
    public Provider() {
      super(
          "background-activity",
          "Removes noise: passes an event if enough of its eight neighbours fired "
              + "shortly before. Publishes the removed share.",
          BackgroundActivitySettings.class,
          BackgroundActivityFilter::new);
    }
  }
}
