package haltere.ui.viewer.space;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;
import haltere.ui.rendering.Letters;
import haltere.ui.rendering.OverlaySnapshots;
import haltere.ui.rendering.SpaceTimeProjection;
import haltere.ui.rendering.SpaceTimeView;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Axes and marks in space and time. */
class SpaceTimeMarksTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(101, 101);

  /** Six pixels for each letter. */
  private static final Letters LETTERS =
      new Letters() {
        @Override
        public double width(String line) {
          return 6.0 * line.length();
        }

        @Override
        public double ascent() {
          return 10;
        }

        @Override
        public double descent() {
          return 3;
        }

        @Override
        public void draw(String line, int left, int base, Dots dots) {
          throw new UnsupportedOperationException("the canvas draws");
        }
      };

  /** Keeps words with their places, and lines. */
  private static final class Notes implements OverlayCanvas {
    final Map<String, double[]> texts = new HashMap<>();
    final List<double[]> lines = new ArrayList<>();
    int zeros;

    @Override
    public void polyline(double[] x, double[] y, int points, MarkStyle style) {
      lines.add(new double[] {x[0], y[0], x[points - 1], y[points - 1]});
    }

    @Override
    public void text(double x, double y, String text, MarkStyle style) {
      texts.put(text, new double[] {x, y});
      zeros += text.equals("0") ? 1 : 0;
    }
  }

  private static Notes notes(double turnDegrees, long spanUs, SpaceTimeSink.Frame frame) {
    SpaceTimeView view =
        new SpaceTimeView(Math.toRadians(turnDegrees), Math.toRadians(20), 1, spanUs, 0, 1);
    Notes notes = new Notes();
    SpaceTimeMarks marks =
        new SpaceTimeMarks(
            new SpaceTimeProjection(view, SENSOR, 500, 500), SENSOR, spanUs, LETTERS, 1, notes);
    marks.drawAxes();
    marks.draw(frame);
    return notes;
  }

  private static Notes notes(double turnDegrees, long spanUs) {
    return notes(turnDegrees, spanUs, new SpaceTimeSink.Frame(1));
  }

  @Test
  void axesHaveNamesUnitsAndTicksUpToTheNewestEvents() {
    Notes notes = notes(55, 100_000);
    assertTrue(
        notes.texts.keySet().containsAll(List.of("x, px", "y, px", "time, ms", "-40", "-100")),
        () -> "" + notes.texts.keySet());
    assertTrue(notes.texts.get("-100")[0] < notes.texts.get("-40")[0], "the past is at the left");
  }

  @Test
  void axesThatMeetShareTheLabelOfTheirOrigin() {
    assertEquals(2, notes(55, 100_000).zeros, "x and time meet, y begins elsewhere");
  }

  @Test
  void timeUnitFollowsTheLengthOfTheAxis() {
    assertTrue(notes(55, 2_000).texts.containsKey("time, \u00b5s"));
    assertTrue(notes(55, 10_000_000).texts.containsKey("time, s"));
  }

  @Test
  void axisAlongTheViewHasNoLabels() {
    SpaceTimeView along = new SpaceTimeView(0, 0, 1, 100_000, 0, 1);
    Notes notes = new Notes();
    new SpaceTimeMarks(
            new SpaceTimeProjection(along, SENSOR, 500, 500), SENSOR, 100_000, LETTERS, 1, notes)
        .drawAxes();
    assertEquals(false, notes.texts.containsKey("time, ms"));
    assertTrue(notes.texts.containsKey("x, px"));
  }

  @Test
  void marksLieInThePlaneOfTheNewestEventsWithTracesBehind() {
    SpaceTimeSink.Frame frame = new SpaceTimeSink.Frame(1);
    frame.nowUs = 500_000;
    frame.marks =
        List.of(
            new OverlaySnapshots.Marks<>(
                0, (snapshot, canvas) -> canvas.text(50, 50, "1", MarkStyle.of(Role.LABEL))));
    frame.traces =
        List.of(
            new MarkTraces.Trace(
                MarkStyle.of(Role.ESTIMATE, 1),
                new ArrayDeque<>(
                    List.of(
                        new MarkTraces.TracePoint(400_000, 50, 50),
                        new MarkTraces.TracePoint(500_000, 50, 50)))));
    Notes notes = notes(90, 100_000, frame);
    double[] trace = notes.lines.get(notes.lines.size() - 1);
    assertEquals(notes.texts.get("1")[0], trace[2], 1e-9, "the trace ends at the mark");
    assertEquals(-trace[2], trace[0], 1e-9, "and begins at the back of the box");
  }
}
