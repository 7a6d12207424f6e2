package haltere.filters.wing.tracker;

import haltere.core.chain.NamedProvider;
import haltere.core.chain.Outlet;
import haltere.core.chain.PublishingFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.SharedWork;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.ManualWingChange;
import haltere.filters.wing.WingAverage;
import haltere.filters.wing.WingBeat;
import haltere.filters.wing.WingDifference;
import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingListener;
import haltere.filters.wing.WingMeasurement;
import haltere.filters.wing.WingPair;
import haltere.filters.wing.WingResult;
import haltere.filters.wing.WingSnapshot;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.WingTrackerState;
import haltere.filters.wing.WingVariances;
import java.util.Map;
import java.util.stream.Stream;

/**
 * {@link WingTracker} as a stage of a chain. Passes all events and publishes the results.
 *
 * <p>Outlets: {@code estimates} of edges and wings, {@code wings} without the edges, {@code
 * averages} of the running average beside the Kalman filter, {@code differences} of both, {@code
 * measurements} (each used event), {@code variances} of the filters, {@code beats}, {@code pairs}
 * of wings, {@code geometry} of the fly, {@code initialisation} step by step, and {@code snapshot}
 * to be drawn.
 */
public final class WingTrackerFilter extends PublishingFilter<WingTrackerSettings> {
  private final Outlet<WingEstimate> estimates = outlet("estimates", WingEstimate.class);
  private final Outlet<WingEstimate> wings = outlet("wings", WingEstimate.class);
  private final Outlet<WingEstimate> averages = outlet("averages", WingEstimate.class);
  private final Outlet<WingDifference> differences = outlet("differences", WingDifference.class);
  private final Map<Class<? extends WingResult>, Outlet<? extends WingResult>> byKind =
      Map.of(
          WingEstimate.class, estimates,
          WingDifference.class, differences,
          WingMeasurement.class, outlet("measurements", WingMeasurement.class),
          WingVariances.class, outlet("variances", WingVariances.class),
          WingBeat.class, outlet("beats", WingBeat.class),
          WingPair.class, outlet("pairs", WingPair.class),
          FlyGeometry.class, outlet("geometry", FlyGeometry.class),
          WingTrackerState.class, outlet("initialisation", WingTrackerState.class),
          WingSnapshot.class,
              drawnOutlet("snapshot", WingSnapshot.class, "wings", new WingOverlay()),
          ManualWingChange.class, new Outlet<>("by-hand", ManualWingChange.class));

  private final WingTracker tracker;

  /**
   * A filter in its initial state.
   *
   * @param geometry the sensor
   * @param settings of the filter
   */
  public WingTrackerFilter(SensorGeometry geometry, WingTrackerSettings settings) {
    tracker = new WingTracker(geometry, settings, new OutletsOfFilter());
  }

  /** {@return the tracker, for settings with manual positions} */
  public WingTracker tracker() {
    return tracker;
  }

  /**
   * The outlet of a kind of results. Manual changes of running Kalman filters are not among {@link
   * #outlets()}, since they are no result.
   *
   * @param kind any kind but {@link WingAverage}
   * @param <R> that kind
   * @return the outlet of both edges and wings for estimates
   */
  @SuppressWarnings("unchecked")
  public <R extends WingResult> Outlet<R> results(Class<R> kind) {
    return (Outlet<R>) byKind.get(kind);
  }

  @Override
  public void process(EventPacket packet) {
    tracker.track(packet);
  }

  @Override
  public void share(SharedWork work) {
    tracker.share(work);
  }

  @Override
  public void reset() {
    tracker.reset();
  }

  /** Time continues over a gap in the data; a lost wing is detected afterwards. */
  @Override
  public boolean bridgesGaps() {
    return true;
  }

  @Override
  public String status() {
    return switch (tracker.phase()) {
      case TRACKING -> "";
      case UNLOCKED -> "Follows the events, not at the frequency of the beat.";
      case ONE_WING -> "Tracks one wing, looks for the other.";
      case LOST -> "Has lost the wings, looks for them.";
      default -> "Waits for wings.";
    };
  }

  @Override
  public WingTrackerSettings settings() {
    return tracker.settings();
  }

  @Override
  public void apply(WingTrackerSettings settings) {
    tracker.apply(settings);
  }

  private final class OutletsOfFilter implements WingListener {
    @Override
    public boolean isRequested(Class<? extends WingResult> kind) {
      return kind == WingEstimate.class
          ? Stream.of(estimates, wings, averages, differences, byKind.get(WingPair.class))
              .anyMatch(Outlet::hasSubscribers)
          : byKind.get(kind).hasSubscribers();
    }

    @Override
    @SuppressWarnings("unchecked")
    public void accept(WingResult result) {
      if (result instanceof WingAverage average) {
        averages.publish(average.estimate());
        return;
      }
      if (result instanceof WingEstimate estimate && estimate.edge().isWing()) {
        wings.publish(estimate);
      }
      ((Outlet<WingResult>) byKind.get(result.getClass())).publish(result);
    }
  }

  /** Creates the filter by its name in a chain. */
  public static final class Provider extends NamedProvider<WingTrackerSettings> {
    /** Called by the service loader. */
    public Provider() {
      super(
          "wing-tracker",
          "Tracks the wings of a tethered fly within each beat.",
          WingTrackerSettings.class,
          WingTrackerFilter::new);
    }

    @Override
    public Map<String, WingTrackerSettings> presets() {
      return Map.of("original", WingTrackerSettings.original());
    }
  }
}
