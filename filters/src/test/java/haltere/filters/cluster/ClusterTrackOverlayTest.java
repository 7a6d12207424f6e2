package haltere.filters.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.OverlayCanvas;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;

class ClusterTrackOverlayTest {
  @Test
  void aClusterIsAnEllipseWithItsPathItsVelocityAndItsIdentity() {
    ClusterTrack before = new ClusterTrack(0, 7, 10, 20, 0, 0, 5, 1, 0, 100, 20, 1000, 0);
    ClusterTrack now =
        new ClusterTrack(10_000, 7, 11, 21, 100, -50, 6, 2.25, 0.5, 200, 20, 1000, 10_000);
    ClusterSnapshot snapshot =
        new ClusterSnapshot(10_000, List.of(new ClusterSnapshot.Trail(List.of(before, now))));
    Notebook notebook = new Notebook();
    new ClusterTrackOverlay().draw(snapshot, notebook);
    assertEquals(
        List.of(
            "PATH 7: [10.0, 11.0] [20.0, 21.0]",
            "OBJECT 7: ellipse 11.0 21.0 half axes 9.0 4.0 at 0.5",
            "VELOCITY 7: line 11.0 21.0 to 21.0 16.0",
            "LABEL 7: 7 at 15.2 25.2"),
        notebook.marks);
  }

  @Test
  void nothingIsDrawnOfNoCluster() {
    Notebook notebook = new Notebook();
    new ClusterTrackOverlay().draw(new ClusterSnapshot(0, List.of()), notebook);
    assertEquals(List.of(), notebook.marks);
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
      note(style, "circle %.1f %.1f radius %.1f", x, y, radius);
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, MarkStyle style) {
      note(style, "line %.1f %.1f to %.1f %.1f", x1, y1, x2, y2);
    }

    @Override
    public void polyline(double[] x, double[] y, int points, MarkStyle style) {
      note(
          style,
          "%s %s",
          Arrays.toString(Arrays.copyOf(x, points)),
          Arrays.toString(Arrays.copyOf(y, points)));
    }

    @Override
    public void ellipse(
        double x, double y, double radiusA, double radiusB, double angleRad, MarkStyle style) {
      note(
          style, "ellipse %.1f %.1f half axes %.1f %.1f at %.1f", x, y, radiusA, radiusB, angleRad);
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
