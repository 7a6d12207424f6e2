package haltere.testing.objects;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class LooksTest {
  /** Sensors of 128x128 and 240x180: larger ones take seconds. */
  private static final int SMALL = 2;

  @ParameterizedTest
  @EnumSource
  void eventsAreDenserInObjectBoxesAndTheTruthScoresOne(Looks.Look look) throws IOException {
    ObjectScene scene = Looks.scene(look, 5, SMALL);
    assertTrue(scene.objects() >= 2 && scene.objects() <= 8);
    assertTrue(EventDensity.of(scene).ratio() > 2, () -> look + " has its events elsewhere");
    ObjectScore score = ObjectScore.of(scene, rows(scene, 0));
    assertEquals(1, score.idf1());
    assertEquals(1, score.mota());
    assertEquals(0, score.accuracy().relativeVelocityRmse());
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void sparseObjectsHaveAsManyEventsInFrontAsBehind(long seed) throws IOException {
    ObjectScene scene = Looks.scene(Looks.Look.SPARSE, seed, SMALL);
    int front = 0;
    int behind = 0;
    EventPacket events = CompositesTest.events(scene);
    for (TruthMoment moment : scene.truth()) {
      for (int i : EventDensity.near(events, moment)) {
        for (TrueObject o : moment.objects()) {
          if (o.box().contains(events.x(i), events.y(i), 0.5)) {
            double s = (events.timeUs(i) - moment.timeUs()) * 1e-6;
            double dx = events.x(i) - o.box().centreX() - o.vxPxS() * s;
            double dy = events.y(i) - o.box().centreY() - o.vyPxS() * s;
            double along = dx * o.vxPxS() + dy * o.vyPxS();
            front += along > 0 ? 1 : 0;
            behind += along < 0 ? 1 : 0;
          }
        }
      }
    }
    assertEquals(1, front / (double) behind, 0.2);
  }

  static List<TrackRow> rows(ObjectScene scene, int delayMoments) {
    List<TrackRow> rows = new ArrayList<>();
    int[] seen = new int[100];
    for (TruthMoment moment : scene.truth()) {
      for (TrueObject o : moment.objects()) {
        if (seen[o.id()]++ >= delayMoments) {
          rows.add(
              new TrackRow(
                  moment.timeUs(),
                  o.id(),
                  o.box().centreX(),
                  o.box().centreY(),
                  o.vxPxS(),
                  o.vyPxS()));
        }
      }
    }
    return rows;
  }

  @Test
  void sameSeedGivesTheSameScene() throws IOException {
    ObjectScene first = Looks.scene(Looks.Look.HIDDEN, 3, SMALL);
    ObjectScene again = Looks.scene(Looks.Look.HIDDEN, 3, SMALL);
    assertEquals(first.truth(), again.truth());
    assertEquals(CompositesTest.events(first), CompositesTest.events(again));
  }

  @Test
  void velocitiesAreTheDerivativesOfPositions() {
    SplittableRandom random = new SplittableRandom(1);
    double h = 1e-5;
    for (int i = 0; i < 50; i++) {
      Motion motion =
          random.nextBoolean()
              ? Motion.line(random, 50, 60, random.nextDouble(6), 40, 3)
              : Motion.orbit(random, 50, 60, 30, 20, 40);
      Motion stopping = motion.stopping(random.nextDouble(1, 4));
      double s = random.nextDouble(0.1, 8);
      assertEquals((stopping.x(s + h) - stopping.x(s - h)) / (2 * h), stopping.vx(s), 0.02);
      assertEquals((stopping.y(s + h) - stopping.y(s - h)) / (2 * h), stopping.vy(s), 0.02);
      assertTrue(Math.hypot(stopping.vx(s), stopping.vy(s)) <= stopping.maxSpeed() + 1e-9);
    }
  }

  @Test
  void stoppingObjectRestsForTwoSeconds() {
    Motion motion = Motion.line(new SplittableRandom(2), 0, 0, 0.3, 40, 2).stopping(1);
    assertEquals(1, motion.pace(0.9));
    assertEquals(0, motion.pace(1.4));
    assertEquals(0, motion.pace(3.2));
    assertEquals(1, motion.pace(3.7));
    assertEquals(motion.x(1.4), motion.x(3.2));
  }
}
