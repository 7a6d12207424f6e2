package haltere.filters.orientation.line;

import haltere.core.chain.NamedProvider;
import haltere.core.chain.Outlet;
import haltere.core.chain.PublishingFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;

/**
 * {@link BodyLineTracker} as a stage of a chain. Passes all events; publishes a {@link BodyLine} at
 * each report, for {@link haltere.filters.orientation.BodyOrientationEstimator} with two or more
 * cameras.
 */
final class BodyLineFilter extends PublishingFilter<BodyLineSettings> {
  private final Outlet<BodyLine> lines =
      drawnOutlet("lines", BodyLine.class, "body line", new BodyLineOverlay());
  private final BodyLineTracker tracker;

  BodyLineFilter(SensorGeometry geometry, BodyLineSettings settings) {
    tracker = new BodyLineTracker(geometry, settings, lines::publish);
  }

  Outlet<BodyLine> lines() {
    return lines;
  }

  @Override
  public void process(EventPacket packet) {
    tracker.track(packet);
  }

  @Override
  public void reset() {
    tracker.reset();
  }

  @Override
  public BodyLineSettings settings() {
    return tracker.settings();
  }

  @Override
  public void apply(BodyLineSettings settings) {
    tracker.apply(settings);
  }

  /** Creates the filter by its name in a chain. */
  public static final class Provider extends NamedProvider<BodyLineSettings> {
    /** Called by the service loader. */
    public Provider() {
      super(
          "body-line",
          "Tracks the line of one elongated body, for its orientation in space.",
          BodyLineSettings.class,
          BodyLineFilter::new);
    }
  }
}
