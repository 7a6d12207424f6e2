package haltere.ui.space;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;
import haltere.filters.orientation.camera.LineObservation;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BodyFlightDrawingTest {
  @TempDir Path folder;

  /** Writes marks down. */
  private static final class Marks implements OverlayCanvas {
    final List<Role> lines = new ArrayList<>();
    final List<double[]> axes = new ArrayList<>();
    final List<String> texts = new ArrayList<>();
    final List<double[]> outlines = new ArrayList<>();
    final List<double[]> bars = new ArrayList<>();
    final List<double[]> observed = new ArrayList<>();

    @Override
    public void circle(double x, double y, double radius, MarkStyle style) {
      axes.add(new double[] {x, y});
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, MarkStyle style) {
      lines.add(style.role());
      if (style.role() == Role.MEASUREMENT || style.role() == Role.WARNING) {
        observed.add(new double[] {x1, y1, x2, y2});
      }
      if (style.role() == Role.LABEL) {
        bars.add(new double[] {x1, y1, x2, y2});
      }
      if (style.role() == Role.ESTIMATE) {
        axes.add(new double[] {x1, y1, x2, y2});
      }
    }

    @Override
    public void polyline(double[] x, double[] y, int points, MarkStyle style) {
      lines.add(style.role());
      if (style.role() == Role.PATH) {
        outlines.add(x);
      }
    }

    @Override
    public void ellipse(
        double x, double y, double radiusA, double radiusB, double angleRad, MarkStyle style) {
      lines.add(style.role());
    }

    @Override
    public void rectangle(double x, double y, double width, double height, MarkStyle style) {
      lines.add(style.role());
    }

    @Override
    public void text(double x, double y, String text, MarkStyle style) {
      texts.add(text);
    }
  }

  private BodyFlight flight() throws IOException {
    return SimulatedFlight.in(folder).load();
  }

  @Test
  void camerasBodyConeAndResidualsAreDrawn() throws IOException {
    BodyFlight flight = flight();
    assertTrue(flight.moments().size() > 90, flight.moments().size() + " moments");
    BodyFlightDrawing drawing = new BodyFlightDrawing(flight);
    SpaceView view = new SpaceView();
    view.fit(drawing.points(), 800, 600);
    Marks marks = new Marks();
    drawing.draw(60, view, marks);
    assertEquals(3 * 5, marks.lines.stream().filter(Role.REGION::equals).count());
    assertEquals(5, marks.lines.stream().filter(Role.UNCERTAINTY::equals).count());
    assertEquals(61, marks.outlines.get(0).length);
    double[] axis = marks.axes.get(0);
    double[] head = marks.axes.get(1);
    assertEquals(axis[2], head[0], 1e-9);
    assertEquals(axis[3], head[1], 1e-9);
    for (int i = 0; i < 3; i++) {
      int camera = i;
      assertTrue(marks.texts.stream().anyMatch(text -> text.startsWith("camera-" + camera)));
    }
    assertTrue(marks.texts.stream().anyMatch(text -> text.matches("camera-. [+-].*\u00b0")));
  }

  @Test
  void floorIsAGridOfSquaresWithACorrectScaleBar() throws IOException {
    BodyFlightDrawing drawing = new BodyFlightDrawing(flight());
    SpaceView view = new SpaceView();
    view.fit(drawing.points(), 800, 600);
    Marks marks = new Marks();
    drawing.draw(60, view, marks);
    assertTrue(marks.lines.stream().filter(Role.SCALE::equals).count() > 6, "lines of the floor");
    assertTrue(marks.texts.contains("x, squares of 20 cm"), () -> "" + marks.texts);
    double[] bar = marks.bars.get(0);
    assertEquals(0.2 * view.pixelsPerM(), bar[2] - bar[0], 1e-6, "20 cm");
    assertTrue(marks.texts.contains("20 cm"), () -> "" + marks.texts);
  }

  private static Marks drawn(CameraLine line) {
    Marks marks = new Marks();
    line.draw(marks);
    return marks;
  }

  @Test
  void acceptedLinesAreSolidAndRejectedLinesDashed() throws IOException {
    int accepted = 0;
    int gated = 0;
    for (BodyFlight.Moment moment : flight().moments()) {
      for (CameraLine line : moment.lines()) {
        Marks marks = drawn(line);
        assertEquals(2, marks.axes.size(), "the axis and its head");
        if (line.observed().isEmpty()) {
          assertEquals(0, marks.observed.size());
          assertEquals(List.of(), marks.texts);
          continue;
        }
        Role role = line.isAccepted() ? Role.MEASUREMENT : Role.WARNING;
        assertEquals(line.isAccepted() ? 2 : 6, marks.observed.size());
        assertEquals(marks.observed.size(), marks.lines.stream().filter(role::equals).count());
        double angleRad = line.observed().get().angleRad();
        for (double[] piece : marks.observed) {
          double across =
              (piece[2] - piece[0]) * Math.sin(angleRad)
                  - (piece[3] - piece[1]) * Math.cos(angleRad);
          assertEquals(0, across, 1e-9, "along the observed line");
          double beside =
              (piece[0] - line.observed().get().xPx()) * Math.sin(angleRad)
                  - (piece[1] - line.observed().get().yPx()) * Math.cos(angleRad);
          assertEquals(0, beside, 1e-9, "through the observed position");
        }
        assertEquals(!line.isAccepted(), marks.texts.get(0).endsWith("gated"), marks.texts.get(0));
        accepted += line.isAccepted() ? 1 : 0;
        gated += !line.isAccepted() ? 1 : 0;
        double[] axis = marks.axes.get(0);
        double off =
            Math.hypot(axis[0] + axis[2] - 2 * line.xPx(), axis[1] + axis[3] - 2 * line.yPx());
        assertEquals(0, off, 1e-9, "the axis is at the estimated position");
      }
    }
    assertTrue(accepted > 200 && gated > 10, accepted + " accepted, " + gated + " gated");
  }

  @Test
  void detectionWithoutALineIsDrawnAsItsNameOnly() throws IOException {
    CameraLine some = flight().moments().get(50).lines().get(0);
    LineObservation blob = new LineObservation(0, 10, 20, Double.NaN, Double.NaN, Double.NaN);
    Marks marks =
        drawn(
            new CameraLine(
                "left", Optional.of(blob), Double.NaN, false, Double.NaN, Double.NaN, Double.NaN));
    assertEquals(List.of("left"), marks.texts);
    assertEquals(List.of(), marks.lines);
    assertEquals(List.of(), marks.axes);
    assertTrue(some.halfLengthPx() > 1);
  }

  @Test
  void allPointsAreVisibleFromAllDirections() throws IOException {
    BodyFlightDrawing drawing = new BodyFlightDrawing(flight());
    SpaceView view = new SpaceView();
    view.fit(drawing.points(), 800, 600);
    for (int turn = 0; turn < 12; turn++) {
      for (double[] point : drawing.points()) {
        double[] at = view.project(point);
        assertTrue(at[0] >= 0 && at[0] <= 800 && at[1] >= 0 && at[1] <= 600);
      }
      view.turn(0.5, turn < 6 ? 0.4 : -0.7);
    }
    double before = view.pixelsPerM();
    view.zoom(2);
    assertEquals(2 * before, view.pixelsPerM(), 1e-9);
  }

  @Test
  void emptyFlightIsDrawnAsItsCamerasOnly() throws IOException {
    BodyFlight empty = new BodyFlight(flight().cameras(), List.of());
    BodyFlightDrawing drawing = new BodyFlightDrawing(empty);
    SpaceView view = new SpaceView();
    view.fit(drawing.points(), 400, 400);
    Marks marks = new Marks();
    drawing.draw(0, view, marks);
    assertEquals(
        List.of("camera-0", "camera-1", "camera-2"),
        marks.texts.stream().filter(text -> text.startsWith("camera")).toList());
    assertEquals(Optional.empty(), marks.axes.stream().findAny());
  }
}
