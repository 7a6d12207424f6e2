package haltere.testing.evaluation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.SplittableRandom;
import java.util.function.IntUnaryOperator;
import org.junit.jupiter.api.Test;

class FramesTest {
  @Test
  void rowsAreGroupedByTime() {
    ObjectPoint a = new ObjectPoint(20, 5, 1, 1);
    ObjectPoint b = new ObjectPoint(20, 3, 2, 2);
    ObjectPoint c = new ObjectPoint(10, 3, 2, 2);
    ObjectPoint d = new ObjectPoint(30, 1, 0, 0);
    Frames frames = Frames.of(List.of(a, b, c), List.of(d));
    assertEquals(
        List.of(
            new Frame(10, List.of(c), List.of()),
            new Frame(20, List.of(b, a), List.of()),
            new Frame(30, List.of(), List.of(d))),
        frames.list());
    assertEquals(2, frames.truthCount());
    assertEquals(1, frames.trackCount());
  }

  @Test
  void givenTimesHaveOneFrameEachAndRowsAtOtherTimesAreRejected() {
    List<ObjectPoint> truth = List.of(new ObjectPoint(10, 1, 0, 0));
    Frames frames = Frames.at(new long[] {30, 10, 20}, truth, List.of());
    assertEquals(List.of(10L, 20L, 30L), frames.list().stream().map(Frame::timeUs).toList());
    assertThrows(
        IllegalArgumentException.class, () -> Frames.at(new long[] {20}, truth, List.of()));
    assertThrows(
        IllegalArgumentException.class, () -> Frames.at(new long[] {20}, List.of(), truth));
  }

  @Test
  void duplicateIdentitiesAndNonFinitePointsAreRejected() {
    List<ObjectPoint> twice = List.of(new ObjectPoint(10, 1, 0, 0), new ObjectPoint(10, 1, 5, 5));
    assertThrows(IllegalArgumentException.class, () -> Frames.of(twice, List.of()));
    assertThrows(IllegalArgumentException.class, () -> Frames.of(List.of(), twice));
    assertThrows(IllegalArgumentException.class, () -> new ObjectPoint(0, 1, Double.NaN, 0));
    assertThrows(
        IllegalArgumentException.class, () -> new ObjectPoint(0, 1, 0, Double.POSITIVE_INFINITY));
  }

  @Test
  void joinedScenesAreWeightedByTheirPoints() {
    // Identities 1 and 2 of the scenes are not the same objects. Truth 4 + 20 + 4 points, switches
    // 1 + 2 + 0, missed and false 0 + 0 + 2: MOTA = 1 − 5/28. IDTP = 2 + 12 + 3 of 28 on each side.
    Frames joined =
        Frames.joined(
            List.of(
                Rows.brokenTrack(),
                Rows.swappedTracks(),
                Frames.of(List.of(), List.of()),
                Rows.outlierTrack()));
    assertEquals(4, joined.truthCount());
    assertEquals(5, joined.trackCount());
    assertEquals(18, joined.list().size());
    assertEquals(1 - 5.0 / 28, new Correspondences(joined, 5).mota(), 1e-12);
    assertEquals(17.0 / 28, IdentityScore.of(joined, 5).idf1(), 1e-12);
    // AssA: 4 pairs of 1/2, 20 of 5/14, 3 of 3/5.
    double assA = (4 * 0.5 + 20 * 5.0 / 14 + 3 * 0.6) / 27;
    assertEquals(assA, HotaScore.of(joined, 5).assA(), 1e-12);
    assertEquals(27.0 / 29, HotaScore.of(joined, 5).detA(), 1e-12);
    long before = Long.MIN_VALUE;
    for (Frame frame : joined.list()) {
      assertTrue(frame.timeUs() > before);
      before = frame.timeUs();
    }
  }

  @Test
  void scoresDoNotDependOnRowOrderOrIdentityNumbers() {
    List<ObjectPoint> truth = new ArrayList<>();
    List<ObjectPoint> tracks = new ArrayList<>();
    SplittableRandom random = new SplittableRandom(11);
    for (int t = 0; t < 60; t++) {
      for (int id = 0; id < 5; id++) {
        double x = (id - 2) * (t - 30) * 0.5;
        double y = id;
        truth.add(new ObjectPoint(t, id, x, y, id - 2, 0));
        if (random.nextDouble() < 0.9) {
          int track = t > 40 ? (id + 1) % 5 : id;
          double noise = random.nextDouble(-2, 2);
          tracks.add(new ObjectPoint(t, track, x + noise, y - noise / 2, id, 0));
        }
      }
    }
    Frames before = Frames.of(truth, tracks);
    List<ObjectPoint> otherTruth = renumbered(truth, id -> 100 - 7 * id);
    List<ObjectPoint> otherTracks = renumbered(tracks, id -> -3 * id);
    Collections.shuffle(otherTruth, new Random(1));
    Collections.shuffle(otherTracks, new Random(2));
    Frames after = Frames.of(otherTruth, otherTracks);
    HotaScore score = HotaScore.of(before, 8);
    assertTrue(score.hota() > 0.2 && score.hota() < 0.9, "a case that is neither good nor bad");
    assertEquals(score.hota(), HotaScore.of(after, 8).hota(), 1e-12);
    assertEquals(score.assA(), HotaScore.of(after, 8).assA(), 1e-12);
    assertEquals(IdentityScore.of(before, 4), IdentityScore.of(after, 4));
    assertEquals(Gospa.of(before, 4).mean(), Gospa.of(after, 4).mean(), 1e-12);
    Correspondences found = new Correspondences(before, 4);
    Correspondences foundAfter = new Correspondences(after, 4);
    assertEquals(found.mota(), foundAfter.mota(), 1e-12);
    assertEquals(found.switches(), foundAfter.switches());
    assertEquals(
        Accuracy.of(before, found, 5).velocityRmse(),
        Accuracy.of(after, foundAfter, 5).velocityRmse(),
        1e-12);
    assertEquals(
        TrackLatency.of(before, found).meanUs(), TrackLatency.of(after, foundAfter).meanUs());
  }

  private static List<ObjectPoint> renumbered(List<ObjectPoint> points, IntUnaryOperator id) {
    List<ObjectPoint> changed = new ArrayList<>();
    for (ObjectPoint p : points) {
      changed.add(new ObjectPoint(p.timeUs(), id.applyAsInt(p.id()), p.x(), p.y(), p.vx(), p.vy()));
    }
    return changed;
  }
}
