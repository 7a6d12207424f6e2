package haltere.testing.objects;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.StringReader;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class ObjectScoreTest {
  private static final long MOMENT_US = 100_000;
  private static final Box LEFT = new Box(10, 10, 30, 20);
  private static final Box RIGHT = new Box(60, 10, 80, 20);

  private final List<TruthMoment> truth = new ArrayList<>();
  private final List<TrackRow> rows = new ArrayList<>();

  private ObjectScore score(Matching matching) {
    return ObjectScore.of(new ObjectScene("test", "test", null, truth, matching), rows);
  }

  /** Ten moments with the same objects. */
  private void always(List<TrueObject> objects, List<Box> ignored) {
    for (int i = 0; i < 10; i++) {
      truth.add(new TruthMoment(i * MOMENT_US, objects, ignored));
    }
  }

  private void track(int id, int first, int last, double x, double y) {
    for (int i = first; i <= last; i++) {
      rows.add(new TrackRow(i * MOMENT_US, id, x, y));
    }
  }

  @Test
  void singleObjectScoresAsInTheReferenceScript() throws IOException {
    truth.addAll(
        LabelledBoxes.read(
            new StringReader(
                """
                t_us,x0_px,y0_px,x1_px,y1_px
                100000,10.0,20.0,30.0,26.0
                120000,12.0,20.0,32.0,26.0
                140000,14.0,20.5,34.0,26.5
                160000,16.0,21.0,36.0,27.0
                180000,18.0,21.0,38.0,27.0
                200000,20.0,21.0,40.0,27.0
                215001,21.5,21.0,41.5,27.0
                """)));
    rows.addAll(
        TrackTable.read(
            new StringReader(
                """
                t_us,id,x_px,y_px
                100000,a,6.0,16.0
                100000,b,5.9,16.0
                110000,a,21.3,23.1
                130000,a,23.0,24.0
                130000,b,25.0,22.0
                130000,c,60.0,60.0
                140000.0,b,24.0,23.0
                150000,b,25.0,23.0
                160000,b,26.0,30.9
                180000,a,28.0,24.5
                180000,c,42.0,31.0
                200000,c,30.0,31.1
                205001,a,31.0,24.0
                """)));
    ObjectScore score = score(Matching.BOX);
    // What the script prints, rounded as Python rounds.
    assertEquals(7, score.points());
    assertEquals("0.857", rounded(score.covered(), 3));
    assertEquals("1.33", rounded(score.tracksOnIt(), 2));
    assertEquals(3, score.identities());
    assertEquals("0.444", rounded(score.idf1(), 3));
    assertEquals("0.429", rounded(score.elsewhere(), 3));
    assertEquals("0.38", rounded(score.offCentre(), 2));
  }

  private static String rounded(double value, int digits) {
    return new BigDecimal(value).setScale(digits, RoundingMode.HALF_EVEN).toString();
  }

  @Test
  void trackReplacedHalfwayLowersIdf1AndAddsOneSwitch() {
    always(List.of(new TrueObject(1, LEFT), new TrueObject(2, RIGHT)), List.of());
    track(7, 0, 9, 20, 15);
    track(8, 0, 4, 70, 15);
    track(9, 5, 9, 70, 15);
    ObjectScore score = score(Matching.BOX);
    // IDTP = 10 + 5 of 20 points on either side; one switch in 20 points.
    assertEquals(0.75, score.idf1(), 1e-15);
    assertEquals(0.95, score.mota(), 1e-15);
    assertEquals(1, score.switches());
    assertEquals(1, score.covered());
    assertEquals(1, score.tracksOnIt());
    assertEquals(1.5, score.identities());
    assertEquals(2, score.objects());
  }

  @Test
  void trackInTwoBoxesCountsForOneObject() {
    always(List.of(new TrueObject(1, LEFT), new TrueObject(2, LEFT.mapped(1, 1, 5, 0))), List.of());
    track(1, 0, 9, 22, 15);
    ObjectScore score = score(Matching.BOX);
    // IDTP = 10 of 20 points of truth and 10 of tracks; 10 of 20 points missed.
    assertEquals(20.0 / 30, score.idf1(), 1e-15);
    assertEquals(0.5, score.mota(), 1e-15);
    assertEquals(1, score.covered());
  }

  @Test
  void tracksInIgnoredRegionsCountOnlyOnAnObject() {
    always(List.of(new TrueObject(1, LEFT)), List.of(RIGHT, LEFT));
    track(1, 0, 9, 20, 15);
    track(2, 0, 9, 70, 15);
    assertEquals(1, score(Matching.BOX).idf1());
    assertEquals(1, score(Matching.BOX).mota());
    track(3, 0, 4, 25, 15);
    // 5 false points beside 10 right ones.
    assertEquals(20.0 / 25, score(Matching.BOX).idf1(), 1e-15);
    assertEquals(0.5, score(Matching.BOX).mota(), 1e-15);
  }

  @Test
  void velocityErrorsExcludeTheFirstHalfSecondOfATrack() {
    always(List.of(new TrueObject(1, LEFT, 10, 0)), List.of());
    for (int i = 0; i < 10; i++) {
      // Errors: 10 px/s in the first half second, then 3 and 4 px/s in x and y.
      double vx = i < 5 ? 20 : 13;
      double vy = i < 5 ? 0 : 4;
      double sd = i < 7 ? 1 : 10;
      rows.add(new TrackRow(i * MOMENT_US, 1, 20, i < 2 ? 15 : 18, vx, vy, 1, 1, sd, sd, 0, 0, 0));
    }
    ObjectScore score = score(Matching.CENTRE);
    assertEquals(0.5, score.accuracy().relativeVelocityRmse(), 1e-12);
    assertEquals(5, score.accuracy().velocityPairs());
    // Squares of 0 and 9 against 5.99; of 25 and 0.25.
    assertEquals(new ObjectScore.Within(10, 2), score.position());
    assertEquals(new ObjectScore.Within(5, 3), score.velocity());
  }

  @Test
  void standardDeviationsAreNotScoredAgainstLabelledBoxes() {
    always(List.of(new TrueObject(1, LEFT)), List.of());
    rows.add(new TrackRow(0, 1, 20, 15, 0, 0, 1, 1, 1, 1, 0, 0, 0));
    assertEquals(0, score(Matching.BOX).position().count());
  }

  @Test
  void matchingToleranceIsInclusive() {
    Box box = new Box(0, 0, 40, 4);
    assertEquals(1, Matching.BOX.distance(box, 44, 8));
    assertTrue(Matching.BOX.distance(box, 44.001, 2) > 1);
    // Half axes of 20 and 4 pixels.
    assertEquals(1, Matching.CENTRE.distance(box, 40, 2));
    assertEquals(1, Matching.CENTRE.distance(box, 20, 6));
    assertTrue(Matching.CENTRE.distance(box, 39, 5) > 1);
    assertEquals(1, Matching.GATE.distance(box, 26, 10));
  }

  @Test
  void sceneWithoutTracksScoresZero() {
    always(List.of(new TrueObject(1, LEFT)), List.of());
    ObjectScore score = score(Matching.BOX);
    assertEquals(0, score.idf1());
    assertEquals(0, score.mota());
    assertEquals(0, score.covered());
  }
}
