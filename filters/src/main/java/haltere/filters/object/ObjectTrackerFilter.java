package haltere.filters.object;

import haltere.core.chain.NamedProvider;
import haltere.core.chain.Outlet;
import haltere.core.chain.PublishingFilter;
import haltere.core.chain.ResultOrder;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.StreamNotification;
import haltere.filters.trail.Ellipse;
import haltere.filters.trail.internal.TrailMark;
import haltere.filters.trail.internal.TrailOverlay;
import haltere.filters.trail.internal.TrailSnapshot;
import haltere.filters.trail.internal.Trails;
import java.util.Comparator;
import java.util.Locale;

/**
 * Tracks moving objects of any shape: an object is one track from its first to its last event, also
 * through stops, gaps and encounters. Passes all events. A noise filter is not required. {@code
 * docs/objects.md} has the model and its sources. Publishes
 *
 * <ul>
 *   <li>{@code objects}: an {@link ObjectTrack} for each object at each report, from events before
 *       that time only. When an identity is decided, the rows since the object's start are
 *       published at once, at most two seconds of them, in order of time;
 *   <li>{@code object-snapshot}: an {@link TrailSnapshot} at each report.
 * </ul>
 *
 * <p>Thread rule: as {@link haltere.core.chain.EventFilter}.
 */
public final class ObjectTrackerFilter extends PublishingFilter<ObjectTrackerSettings> {
  /** Maximum age of the rows of a newly decided identity, seconds. */
  public static final double UNDECIDED_S = 2;

  private final Outlet<ObjectTrack> tracks =
      outlet(
          "objects",
          ObjectTrack.class,
          new ResultOrder<>(
              Math.round(UNDECIDED_S * 1e6),
              ObjectTrack::timeUs,
              Comparator.comparingInt(ObjectTrack::id)));
  private final Outlet<TrailSnapshot> snapshots =
      drawnOutlet("object-snapshot", TrailSnapshot.class, "objects", new TrailOverlay());
  private final Trails trails = new Trails();
  private final ObjectTracker tracker;

  /**
   * A filter in its initial state.
   *
   * @param geometry the sensor
   * @param settings of the filter
   */
  public ObjectTrackerFilter(SensorGeometry geometry, ObjectTrackerSettings settings) {
    tracker =
        new ObjectTracker(
            geometry,
            settings,
            this::accept,
            this::reported,
            () -> tracks.hasSubscribers() || snapshots.hasSubscribers());
  }

  @Override
  public void process(EventPacket packet) {
    tracker.track(packet);
  }

  @Override
  public void reset() {
    tracker.reset();
    trails.clear();
  }

  /** {@inheritDoc} Identities restart. */
  @Override
  public void rewind() {
    reset();
    tracker.restartIdentities();
  }

  @Override
  public void notified(StreamNotification notification) {
    if (notification instanceof EndOfStream) {
      tracker.finish();
    }
    super.notified(notification);
  }

  /** Time continues over a gap in the data, with the usual memory of objects. */
  @Override
  public boolean bridgesGaps() {
    return true;
  }

  @Override
  public String status() {
    return tracker.hasObjects()
        ? ""
        : String.format(
            Locale.ROOT,
            "No objects yet: an object is confirmed after %.1f s of motion.",
            settings().confirmS());
  }

  /** {@return the outlet of the objects, a result for each object at each report} */
  public Outlet<ObjectTrack> tracks() {
    return tracks;
  }

  @Override
  public ObjectTrackerSettings settings() {
    return tracker.settings();
  }

  @Override
  public void apply(ObjectTrackerSettings settings) {
    tracker.apply(settings);
  }

  /**
   * Applies a motion model from the next packet on.
   *
   * @param model such as that of a road
   */
  public void apply(MotionModel model) {
    tracker.apply(model);
  }

  private void reported(long timeUs) {
    if (snapshots.hasSubscribers()) {
      snapshots.publish(trails.at(timeUs));
    }
  }

  private void accept(ObjectTrack track) {
    tracks.publish(track);
    if (snapshots.hasSubscribers()) {
      int maxRows = 1 + (int) Math.round(settings().pathS() * settings().reportRateHz());
      trails.add(
          track,
          new TrailMark(
              Role.ESTIMATE,
              new Ellipse(track.majorPx(), track.minorPx(), track.angleRad()),
              false,
              Integer.toString(track.id()),
              0),
          maxRows);
    }
  }

  /** Creates the filter by its name in a chain. */
  public static final class Provider extends NamedProvider<ObjectTrackerSettings> {
    /** Called by the service loader. */
    public Provider() {
      super(
          "object-tracker",
          "Tracks moving objects of any shape through stops, gaps and encounters; needs"
              + " no noise filter before it.",
          ObjectTrackerSettings.class,
          ObjectTrackerFilter::new);
    }
  }
}
