package haltere.core.simulation.internal.dots;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.simulation.SceneRuns;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Dots follow their paths, and events lie on the dots. */
class MovingDotsSceneTest {
  private static MovingDotsSettings quiet(String... assignments) {
    return MovingDotsSettings.defaults()
        .with("noise.leakHz=0", "noise.shotHz=0", "noise.hotPixels=0")
        .with(assignments);
  }

  @ParameterizedTest
  @EnumSource(DotPath.class)
  void velocityIsTheDerivativeOfPositionWithTheSpeedOfTheSettings(DotPath path) {
    MovingDotsScene scene = new MovingDotsScene(quiet("dots.path=" + path));
    int turns = 0;
    for (long us = 0; us < 3_000_000; us += 9_973) {
      List<DotTruth> now = scene.truthRows(us);
      List<DotTruth> later = scene.truthRows(us + 100);
      for (int i = 0; i < now.size(); i++) {
        DotTruth dot = now.get(i);
        assertEquals(150, Math.hypot(dot.vxPxS(), dot.vyPxS()), 1e-6);
        double missed =
            Math.hypot(
                later.get(i).xPx() - dot.xPx() - dot.vxPxS() * 1e-4,
                later.get(i).yPx() - dot.yPx() - dot.vyPxS() * 1e-4);
        turns += missed > 1e-4 ? 1 : 0;
      }
    }

    assertTrue(turns < 12, turns + " turns seen");
  }

  @ParameterizedTest
  @EnumSource(DotPath.class)
  void theDotsStayOnTheSensor(DotPath path) {
    MovingDotsScene scene =
        new MovingDotsScene(quiet("dots.path=" + path, "sensor.widthPx=64", "sensor.heightPx=48"));
    for (long us = 0; us < 3_000_000; us += 9_973) {
      for (DotTruth dot : scene.truthRows(us)) {
        assertTrue(dot.xPx() > 2 && dot.xPx() < 61, dot.toString());
        assertTrue(dot.yPx() > 2 && dot.yPx() < 45, dot.toString());
      }
    }
  }

  @Test
  void eventsLieOnDotEdgesWithOffInFrontAndOnBehind() {
    MovingDotsScene scene = new MovingDotsScene(quiet("run.durationS=1", "dots.radiusPx=5"));
    EventPacket events = SceneRuns.events(scene);
    int inFront = 0;
    for (int i = 0; i < events.size(); i++) {
      int index = i;
      double best = Double.POSITIVE_INFINITY;
      boolean front = false;
      for (DotTruth dot : scene.truthRows(events.timeUs(index))) {
        double dx = events.x(i) - dot.xPx();
        double dy = events.y(i) - dot.yPx();
        double fromEdge = Math.abs(Math.hypot(dx, dy) - 5);
        if (fromEdge < best) {
          best = fromEdge;
          front = dx * dot.vxPxS() + dy * dot.vyPxS() > 0;
        }
      }
      assertTrue(best < 0.75, "distance from the nearest edge " + best);
      inFront += front == events.isOn(i) ? 0 : 1;
    }

    assertTrue(inFront > 0.93 * events.size(), inFront + " of " + events.size());
  }

  @Test
  void eventCountEqualsTheSweptPixels() {
    EventPacket events =
        SceneRuns.events(new MovingDotsScene(quiet("run.durationS=5", "dots.eventsPerPixel=2")));
    double expected = 4 * 2 * (2 * 3) * 150 * 2 * 5;

    assertEquals(expected, events.size(), 4 * Math.sqrt(expected));
  }

  @Test
  void crossingDotsMeetInTheMiddle() {
    MovingDotsScene scene = new MovingDotsScene(quiet("dots.path=crossing", "dots.count=2"));

    for (DotTruth dot : scene.truthRows(0)) {
      assertEquals(63.5, dot.xPx(), 1e-9);
      assertEquals(63.5, dot.yPx(), 1e-9);
    }
  }

  @Test
  void eventsAreReproducibleAndOrdered() {
    MovingDotsSettings settings = MovingDotsSettings.defaults().with("run.durationS=0.5");

    EventPacket events = SceneRuns.events(new MovingDotsScene(settings));
    assertTrue(events.size() > 3000);
    assertEquals(events, SceneRuns.events(new MovingDotsScene(settings)));
  }
}
