package haltere.ui.space;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;
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

    @Override
    public void circle(double x, double y, double radius, MarkStyle style) {
      axes.add(new double[] {x, y});
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, MarkStyle style) {
      lines.add(style.role());
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
  void everythingIsInSightFromAllSides() throws IOException {
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
  void whereNothingWasFoundTheCamerasAreDrawnAlone() throws IOException {
    BodyFlight empty = new BodyFlight(flight().cameras(), List.of());
    BodyFlightDrawing drawing = new BodyFlightDrawing(empty);
    SpaceView view = new SpaceView();
    view.fit(drawing.points(), 400, 400);
    Marks marks = new Marks();
    drawing.draw(0, view, marks);
    assertEquals(List.of("camera-0", "camera-1", "camera-2"), marks.texts);
    assertEquals(Optional.empty(), marks.axes.stream().findAny());
  }
}
