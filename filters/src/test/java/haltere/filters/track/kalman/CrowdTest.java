package haltere.filters.track.kalman;

import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.simulation.dots.DotTruth;
import haltere.core.simulation.dots.MovingDotsScene;
import haltere.core.simulation.dots.MovingDotsSettings;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.TrackPoint;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

/** Twenty dots of three pixels that are all there from the beginning, and pass near each other. */
class CrowdTest {
  private static final long BEGUN_US = 300_000;
  private static final long END_US = 1_600_000;
  private static final double NEAR_PX = 6;

  private record Result(double followed, double tooMany) {}

  private static Result follow(String... assignments) {
    MovingDotsScene scene =
        new MovingDotsScene(
            MovingDotsSettings.defaults()
                .with(
                    "sensor.widthPx=640",
                    "sensor.heightPx=480",
                    "dots.count=20",
                    "dots.speedPxS=300",
                    "noise.leakHz=0",
                    "noise.hotPixels=0")
                .with(assignments));
    KalmanTracksFilter filter =
        new KalmanTracksFilter(scene.geometry(), KalmanTracksSettings.defaults());
    Map<Long, List<TrackPoint>> reports = new TreeMap<>();
    filter
        .points()
        .subscribe(at -> reports.computeIfAbsent(at.timeUs(), t -> new ArrayList<>()).add(at));
    boolean[] over = new boolean[1];
    while (!over[0]) {
      scene.next(
          new StreamHandler() {
            @Override
            public void packet(EventPacket packet) {
              over[0] = packet.timesUs()[packet.size() - 1] > END_US;
              filter.process(packet);
            }

            @Override
            public void notified(StreamNotification notification) {
              // a scene in one piece
            }
          });
    }
    double dots = 0;
    double followed = 0;
    double tooMany = 0;
    for (Map.Entry<Long, List<TrackPoint>> report : reports.entrySet()) {
      if (report.getKey() < BEGUN_US || report.getKey() > END_US) {
        continue;
      }
      List<TrackPoint> left = report.getValue();
      for (DotTruth dot : scene.truthRows(report.getKey())) {
        dots++;
        followed += left.removeIf(at -> isNear(at, dot)) ? 1 : 0;
      }
      tooMany += left.size();
    }
    return new Result(followed / dots, tooMany / dots);
  }

  private static boolean isNear(TrackPoint at, DotTruth dot) {
    return Math.hypot(at.xPx() - dot.xPx(), at.yPx() - dot.yPx()) < NEAR_PX;
  }

  private static void assertFollowed(Result result) {
    assertTrue(result.followed() > 0.99, result.toString());
    assertTrue(result.tooMany() < 0.01, result.toString());
  }

  @Test
  void eachOfManyDotsOnCirclesWithinOneAnotherIsFollowed() {
    assertFollowed(follow("dots.path=circles", "dots.eventsPerPixel=9.3"));
  }

  @Test
  void soIsEachWhereHalfOfTheEventsAreNoise() {
    assertFollowed(follow("dots.path=circles", "dots.eventsPerPixel=4.65", "noise.shotHz=1.09"));
  }
}
