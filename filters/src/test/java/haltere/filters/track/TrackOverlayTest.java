package haltere.filters.track;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.event.SensorGeometry;
import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.OverlayCanvas;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class TrackOverlayTest {
  private static final TrackPoint BEFORE = new TrackPoint(0, 7, 10, 20, 0, 0, 1, 1, 1, 1, 5);
  private static final TrackPoint NOW = new TrackPoint(10_000, 7, 11, 21, 100, -50, 2, 1, 1, 1, 9);

  @Test
  void aTrackIsItsEllipseItsWayItsVelocityAndItsIdentity() {
    assertEquals(
        List.of(
            "PATH 7: [10.0, 11.0] [20.0, 21.0]",
            "ESTIMATE 7: line 9.0 21.0 to 13.0 21.0",
            "ESTIMATE 7: line 11.0 19.0 to 11.0 23.0",
            "UNCERTAINTY 7: ellipse 11.0 21.0 axes 4.90 2.45 at 0.00",
            "VELOCITY 7: line 11.0 21.0 to 21.0 16.0",
            "LABEL 7: 7 at 14.0 24.0"),
        drawn(new TrackSnapshot.Shown(List.of(BEFORE, NOW), 0, false, Double.NaN, Double.NaN)));
  }

  @Test
  void onARoadTheSpeedIsWrittenWithItsStandardDeviationAndACoastingTrackStandsOut() {
    List<String> marks = drawn(new TrackSnapshot.Shown(List.of(NOW), 0, true, 53.7, 2.2));
    assertEquals("LABEL 7: 7: 54 \u00b1 2 km/h at 14.0 24.0", marks.get(5));
    assertEquals("WARNING 7: ellipse 11.0 21.0 axes 4.90 2.45 at 0.00", marks.get(3));
  }

  @Test
  void theEllipseLiesAlongTheLargerUncertainty() {
    TrackPoint diagonal = new TrackPoint(0, 1, 0, 0, 0, 0, 1, 1, 1, 1, 1);
    List<String> marks =
        drawn(new TrackSnapshot.Shown(List.of(diagonal), -1, false, Double.NaN, Double.NaN));
    assertEquals("UNCERTAINTY 1: ellipse 0.0 0.0 axes 3.46 0.00 at -0.79", marks.get(3));
  }

  @Test
  void aRoadIsWhereItVanishesItsLanesAndItsLinesWithTheirCounts() {
    SensorGeometry sensor = new SensorGeometry(128, 128);
    RoadSettings view = new RoadSettings(5, 6, 300, VanishingPoint.at(63.5, 127));
    RoadMapping mapping = new RoadMapping(view, sensor);
    RoadMarks road =
        new RoadMarks(
            mapping,
            sensor,
            new LaneSettings(1, -1, 2),
            List.of(new RoadMarks.Line(25, 3, 4), new RoadMarks.Line(5, 0, 0)));
    List<String> marks = drawn(new TrackSnapshot(0, List.of(), Optional.of(road)));
    assertEquals("REGION -1: line 59.5 127.0 to 67.5 127.0", marks.get(0));
    assertEquals("REGION -1: line 63.5 123.0 to 63.5 131.0", marks.get(1));
    double column = mapping.columnOf(-1, 25);
    double row = mapping.rowOf(25);
    assertEquals(
        String.format(
            Locale.ROOT,
            "REGION -1: line %.1f %.1f to %.1f %.1f",
            column,
            row,
            mapping.columnOf(1, 25),
            row),
        marks.get(4));
    assertEquals(
        String.format(Locale.ROOT, "REGION -1: 25 m \u21913 \u21934 at %.1f %.1f", column, row + 1),
        marks.get(5));
    assertEquals(6, marks.size(), "a line nearer than the bottom row is not in the picture");
  }

  @Test
  void onARoadTheNearestIsLabelledFirstAndAllLabelsComeAfterAllElse() {
    SensorGeometry sensor = new SensorGeometry(128, 128);
    RoadMapping mapping =
        new RoadMapping(new RoadSettings(5, 6, 300, VanishingPoint.at(63.5, 127)), sensor);
    RoadMarks road = new RoadMarks(mapping, sensor, new LaneSettings(0, 0, 3), List.of());
    List<String> marks =
        drawn(new TrackSnapshot(0, List.of(at(1, 90), at(2, 10), at(3, 50)), Optional.of(road)));
    assertEquals(
        List.of("LABEL 2: 2: 50", "LABEL 3: 3: 50", "LABEL 1: 1: 50"),
        marks.subList(marks.size() - 3, marks.size()).stream()
            .map(mark -> mark.substring(0, mark.indexOf(" \u00b1")))
            .toList());
  }

  private static TrackSnapshot.Shown at(int id, double yPx) {
    TrackPoint point = new TrackPoint(0, id, 64, yPx, 0, 0, 1, 1, 1, 1, 1);
    return new TrackSnapshot.Shown(List.of(point), 0, false, 50, 1);
  }

  private static List<String> drawn(TrackSnapshot.Shown track) {
    return drawn(new TrackSnapshot(10_000, List.of(track), Optional.empty()));
  }

  private static List<String> drawn(TrackSnapshot snapshot) {
    Notebook notebook = new Notebook();
    new TrackOverlay().draw(snapshot, notebook);
    return notebook.marks;
  }

  /** A canvas that writes down what is drawn. */
  private static final class Notebook implements OverlayCanvas {
    final List<String> marks = new ArrayList<>();

    private void note(MarkStyle style, String format, Object... values) {
      marks.add(
          style.role()
              + " "
              + style.identity()
              + ": "
              + String.format(Locale.ROOT, format, values));
    }

    @Override
    public void circle(double x, double y, double radius, MarkStyle style) {
      note(style, "circle");
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, MarkStyle style) {
      note(style, "line %.1f %.1f to %.1f %.1f", x1, y1, x2, y2);
    }

    @Override
    public void polyline(double[] x, double[] y, int points, MarkStyle style) {
      note(style, "%s %s", Arrays.toString(x), Arrays.toString(y));
    }

    @Override
    public void ellipse(
        double x, double y, double radiusA, double radiusB, double angleRad, MarkStyle style) {
      note(style, "ellipse %.1f %.1f axes %.2f %.2f at %.2f", x, y, radiusA, radiusB, angleRad);
    }

    @Override
    public void rectangle(double x, double y, double width, double height, MarkStyle style) {
      note(style, "rectangle");
    }

    @Override
    public void text(double x, double y, String text, MarkStyle style) {
      note(style, "%s at %.1f %.1f", text, x, y);
    }
  }
}
