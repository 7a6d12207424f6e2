package haltere.testing.evaluation;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class FollowedObjectsTest {
  private static final double GATE = 10;
  private static final int STEPS = 60;
  private static final long STEP_US = 10_000;

  /** Two objects that pass each other at 100 px/s, 1 px apart. */
  private static ObjectPoint object(int id, int step) {
    int direction = id == 1 ? 1 : -1;
    return new ObjectPoint(
        step * STEP_US, id, direction * (step - STEPS / 2), id, direction * 100, 0);
  }

  private static ObjectPoint track(int id, ObjectPoint at) {
    return new ObjectPoint(at.timeUs(), id, at.x() + 0.8, at.y(), at.vx() + 3, at.vy());
  }

  private static List<Match> followed(boolean exchanged) {
    List<ObjectPoint> truth = new ArrayList<>();
    List<ObjectPoint> tracks = new ArrayList<>();
    for (int step = 0; step < STEPS; step++) {
      boolean passed = step > STEPS / 2;
      for (int id = 1; id <= 2; id++) {
        truth.add(object(id, step));
        tracks.add(track(10 * id, object(exchanged && passed ? 3 - id : id, step)));
      }
    }
    return FollowedObjects.of(Frames.of(truth, tracks), GATE);
  }

  @Test
  void tracksThatPassEachOtherAreOnTheirOwnObjectsAllTheTime() {
    List<Match> matches = followed(false);
    assertEquals(2 * STEPS, matches.size());
    for (Match match : matches) {
      assertEquals(10 * match.truth().id(), match.track().id(), match.toString());
    }
  }

  @Test
  void tracksThatExchangeTheirObjectsAreOnTheOtherOneFromThenOn() {
    List<Match> matches = followed(true);
    assertEquals(2 * STEPS, matches.size());
    for (Match match : matches) {
      boolean passed = match.truth().timeUs() > STEPS / 2 * STEP_US;
      int own = passed ? 3 - match.truth().id() : match.truth().id();
      assertEquals(10 * own, match.track().id(), match.toString());
    }
  }

  @Test
  void aTrackThatIsFarFromEverythingIsOnNoObject() {
    ObjectPoint truth = new ObjectPoint(0, 1, 0, 0, 0, 0);
    ObjectPoint near = new ObjectPoint(0, 7, 9, 0, 50, 0);
    ObjectPoint far = new ObjectPoint(0, 8, 11, 0, 0, 0);
    List<Match> matches = FollowedObjects.of(Frames.of(List.of(truth), List.of(near, far)), GATE);
    assertEquals(List.of(new Match(truth, near, false)), matches);
  }
}
