package haltere.filters.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.EventFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.overlay.MarkStyle.Role;
import haltere.filters.plane.PlanePoint;
import haltere.filters.trail.internal.TrailSnapshot;
import haltere.testing.EventFilterContract;
import haltere.testing.EventPackets;
import haltere.testing.EventPackets.BlobPath;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;

class KalmanTracksFilterTest extends EventFilterContract {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);

  @Override
  protected EventFilter create(SensorGeometry geometry) {
    return new KalmanTracksFilter(geometry, KalmanTracksSettings.defaults());
  }

  @Override
  protected EventPacket stream(SensorGeometry geometry, long seed) {
    BlobPath path =
        new BlobPath(
            geometry.width() / 2.0, geometry.height() / 2.0, geometry.height() / 3.0, 7e5, 3);
    return EventPackets.blob(geometry, seed, 1_000_000, path, 30_000, 2);
  }

  @Override
  protected Object withoutIdentity(Object result) {
    if (result instanceof TrackUpdate u) {
      return List.of(u.timeUs(), u.x(), u.y(), u.vx(), u.vy(), u.nis(), u.pXx());
    }
    if (result instanceof TrailSnapshot snapshot) {
      return snapshot.trails().stream()
          .map(trail -> trail.path().stream().map(this::withoutIdentity).toList())
          .toList();
    }
    if (result instanceof TrackPoint p) {
      return List.of(
          p.timeUs(), p.xPx(), p.yPx(), p.vxPxS(), p.vyPxS(), p.sdXPx(), p.sdVxPxS(), p.events());
    }
    return result;
  }

  private static <T> List<T> results(KalmanTracksFilter filter, Class<T> type) {
    List<T> results = new ArrayList<>();
    filter.outlets().stream()
        .filter(outlet -> outlet.type() == type)
        .forEach(outlet -> outlet.subscribe(result -> results.add(type.cast(result))));
    return results;
  }

  @Test
  void outletsPublishTheirDeclaredTypes() {
    BlobPath circle = new BlobPath(64, 40, 25, 1_000_000, 4);
    KalmanTracksFilter filter =
        new KalmanTracksFilter(SENSOR, KalmanTracksSettings.defaults().with("road.mapToRoad=true"));
    List<TrackPoint> points = results(filter, TrackPoint.class);
    List<PlanePoint> onRoad = results(filter, PlanePoint.class);
    List<TrackUpdate> updates = results(filter, TrackUpdate.class);
    List<TrailSnapshot> snapshots = results(filter, TrailSnapshot.class);
    filter.process(EventPackets.blob(SENSOR, 3, 500_000, circle, 20_000, 0));
    assertTrue(points.size() > 40, points.size() + " points");
    assertEquals(points.size(), onRoad.size());
    assertTrue(updates.size() > 40, updates.size() + " updates");
    TrailSnapshot last = snapshots.get(snapshots.size() - 1);
    assertEquals(points.get(points.size() - 1), last.trails().get(0).now());
    String speed =
        String.format(Locale.ROOT, "%.0f km/h", onRoad.get(onRoad.size() - 1).speedKmH());
    assertEquals("1: " + speed, last.trails().get(0).mark().label());
    assertEquals(points.size(), last.trails().get(0).path().size());
    assertEquals(Role.UNCERTAINTY, last.trails().get(0).mark().role());
  }

  @Test
  void newSettingsKeepTheTracksUnlessTheRoadChanges() {
    BlobPath circle = new BlobPath(64, 40, 25, 1_000_000, 4);
    EventPacket events = EventPackets.blob(SENSOR, 4, 900_000, circle, 20_000, 0);
    KalmanTracksFilter filter = new KalmanTracksFilter(SENSOR, KalmanTracksSettings.defaults());
    List<TrackPoint> points = results(filter, TrackPoint.class);
    filter.process(EventPackets.part(events, 0, events.indexAtOrAfter(300_000)));
    filter.apply(
        filter.settings().with("reportRateHz=50", "minProcessVariance=500", "noise=per-update"));
    int third = events.indexAtOrAfter(600_000);
    filter.process(EventPackets.part(events, events.indexAtOrAfter(300_000), third));
    assertTrue(points.stream().allMatch(point -> point.id() == 1));
    assertEquals(580_000, points.get(points.size() - 1).timeUs());
    filter.apply(filter.settings().with("mapToRoad=true"));
    points.clear();
    filter.process(EventPackets.part(events, third, events.size()));
    assertTrue(points.size() > 10);
    assertTrue(points.stream().allMatch(point -> point.id() == 2));
  }

  @Test
  void endOfTheLastTrackIsPublishedOnce() {
    BlobPath still = new BlobPath(64, 64, 0, 1, 4);
    EventPacket events = EventPackets.blob(SENSOR, 5, 300_000, still, 20_000, 0);
    events.append(5_000_000, 3, 3, true);
    KalmanTracksFilter filter = new KalmanTracksFilter(SENSOR, KalmanTracksSettings.defaults());
    List<TrailSnapshot> snapshots = results(filter, TrailSnapshot.class);
    filter.process(events);
    TrailSnapshot last = snapshots.get(snapshots.size() - 1);
    assertEquals(List.of(), last.trails());
    TrailSnapshot before = snapshots.get(snapshots.size() - 2);
    assertEquals(Role.WARNING, before.trails().get(0).mark().role());
    // The cluster is visible until 0.5 s or so, and the track continues for half a second.
    assertEquals(1_000_000, last.timeUs(), 100_000);
  }
}
