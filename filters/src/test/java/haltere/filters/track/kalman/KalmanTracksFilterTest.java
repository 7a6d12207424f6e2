package haltere.filters.track.kalman;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.EventFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.dots.MovingDotsScene;
import haltere.core.simulation.dots.MovingDotsSettings;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.TrackPoint;
import haltere.filters.track.TrackSnapshot;
import haltere.filters.track.TrackUpdate;
import haltere.testing.EventFilterContract;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class KalmanTracksFilterTest extends EventFilterContract {
  @Override
  protected EventFilter create(SensorGeometry geometry) {
    return new KalmanTracksFilter(geometry, KalmanTracksSettings.defaults());
  }

  @Override
  protected EventPacket stream(SensorGeometry geometry, long seed) {
    return dots(geometry, seed, 500_000);
  }

  static EventPacket dots(SensorGeometry geometry, long seed, long untilUs) {
    MovingDotsScene scene =
        new MovingDotsScene(
            MovingDotsSettings.defaults()
                .with(
                    "sensor.widthPx=" + Math.max(16, geometry.width()),
                    "sensor.heightPx=" + Math.max(16, geometry.height()),
                    "dots.count=3",
                    "run.seed=" + seed));
    EventPacket all = new EventPacket(0);
    StreamHandler collect =
        new StreamHandler() {
          @Override
          public void packet(EventPacket packet) {
            for (int i = 0; i < packet.size(); i++) {
              if (geometry.contains(packet.x(i), packet.y(i))) {
                all.append(packet.timeUs(i), packet.x(i), packet.y(i), packet.isOn(i));
              }
            }
          }

          @Override
          public void notified(StreamNotification notification) {
            // only the events are wanted
          }
        };
    while (all.isEmpty() || all.lastTimeUs() < untilUs) {
      scene.next(collect);
    }
    return all;
  }

  @Override
  protected Object withoutIdentity(Object result) {
    if (result instanceof TrackPoint p) {
      return withoutIdentity(p);
    }
    if (result instanceof TrackUpdate u) {
      return List.of(u.timeUs(), u.x(), u.y(), u.vx(), u.vy(), u.nis(), u.pXx(), u.accepted());
    }
    if (result instanceof TrackSnapshot snapshot) {
      return snapshot.tracks().stream()
          .map(track -> track.path().stream().map(this::withoutIdentity).toList())
          .toList();
    }
    return result;
  }

  private Object withoutIdentity(TrackPoint p) {
    return List.of(
        p.timeUs(), p.xPx(), p.yPx(), p.vxPxS(), p.vyPxS(), p.sdXPx(), p.sdVxPxS(), p.events());
  }

  @Test
  void theDotsOfASceneAreFollowed() {
    SensorGeometry sensor = new SensorGeometry(128, 128);
    KalmanTracksFilter filter = new KalmanTracksFilter(sensor, KalmanTracksSettings.defaults());
    List<TrackPoint> points = new ArrayList<>();
    List<TrackUpdate> updates = new ArrayList<>();
    List<TrackSnapshot> snapshots = new ArrayList<>();
    filter.points().subscribe(points::add);
    filter
        .outlets()
        .forEach(outlet -> outlet.subscribe(result -> note(result, updates, snapshots)));
    filter.process(dots(sensor, 3, 1_000_000));
    filter.notified(new EndOfStream(1_000_000));
    long lastUs = points.get(points.size() - 1).timeUs();
    long shown = points.stream().filter(point -> point.timeUs() == lastUs).count();
    assertEquals(3, shown);
    assertEquals(shown, snapshots.get(snapshots.size() - 1).tracks().size());
    double nis =
        updates.stream().mapToDouble(TrackUpdate::nis).filter(v -> v < 30).average().orElseThrow();
    assertTrue(nis > 1 && nis < 4, "mean NIS " + nis);
  }

  private static void note(
      Object result, List<TrackUpdate> updates, List<TrackSnapshot> snapshots) {
    if (result instanceof TrackUpdate update) {
      updates.add(update);
    } else if (result instanceof TrackSnapshot snapshot) {
      snapshots.add(snapshot);
    }
  }

  @Test
  void otherSettingsForMotionOrRoadBeginAnewAndOthersKeepTheTracks() {
    SensorGeometry sensor = new SensorGeometry(128, 128);
    KalmanTracksFilter filter = new KalmanTracksFilter(sensor, KalmanTracksSettings.defaults());
    List<TrackPoint> points = new ArrayList<>();
    filter.points().subscribe(points::add);
    EventPacket all = dots(sensor, 3, 1_000_000);
    int half = all.indexAtOrAfter(500_000);
    EventPacket first = new EventPacket(0);
    first.append(all, 0, half);
    EventPacket second = new EventPacket(0);
    second.append(all, half, all.size());
    filter.process(first);
    int lastId = points.stream().mapToInt(TrackPoint::id).max().orElseThrow();
    filter.apply(filter.settings().withReportRate(50));
    filter.apply(filter.settings().with("motion.model=straight"));
    points.clear();
    filter.process(second);
    assertTrue(points.stream().allMatch(point -> point.id() > lastId), "tracks went on");
    assertTrue(points.stream().allMatch(point -> point.timeUs() % 20_000 == 0));
  }
}
