package haltere.filters.wing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.OverlayCanvas;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class WingOverlayTest {
  /** Writes down the marks. */
  private static final class Marks implements OverlayCanvas {
    final List<String> all = new ArrayList<>();
    final List<double[]> lines = new ArrayList<>();

    @Override
    public void circle(double x, double y, double radius, MarkStyle style) {
      all.add("circle " + style.role());
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, MarkStyle style) {
      all.add("line " + style.role());
      lines.add(new double[] {x1, y1, x2, y2});
    }

    @Override
    public void polyline(double[] x, double[] y, int points, MarkStyle style) {
      all.add("arc " + style.role());
    }

    @Override
    public void ellipse(
        double x, double y, double radiusA, double radiusB, double angleRad, MarkStyle style) {
      all.add("ellipse " + style.role());
    }

    @Override
    public void rectangle(double x, double y, double width, double height, MarkStyle style) {
      all.add("rectangle " + style.role());
    }

    @Override
    public void text(double x, double y, String text, MarkStyle style) {
      all.add(text);
    }
  }

  private static Marks draw(double left, double right) {
    FlyGeometry fly = new FlyGeometry(50, 60, Math.PI / 2, 40, 47, 60, 53, 60, 0.9, 0);
    Marks marks = new Marks();
    new WingOverlay()
        .draw(
            new WingSnapshot(
                0,
                WingTrackerState.Phase.TRACKING,
                fly,
                42,
                new double[] {left, left, right, right},
                new double[] {0.02, 0.02}),
            marks);
    return marks;
  }

  @Test
  void drawsBodyHingesRegionFourEdgesAndTheirUncertainty() {
    Marks marks = draw(1.5, 1.6);
    assertEquals(2, marks.all.stream().filter("line LEFT"::equals).count());
    assertEquals(2, marks.all.stream().filter("line RIGHT"::equals).count());
    assertEquals(2, marks.all.stream().filter("arc UNCERTAINTY"::equals).count());
    assertTrue(marks.all.contains("ellipse OBJECT"));
    assertTrue(marks.all.contains("circle REGION"));
    assertTrue(marks.all.contains("head 90 %"));
  }

  @Test
  void aWingAtARightAngleToTheHeadingPointsToItsSide() {
    Marks marks = draw(Math.PI / 2, Math.PI / 2);
    double[] left = marks.lines.get(1);
    double[] right = marks.lines.get(3);
    assertEquals(47 - 40, left[2], 1e-9);
    assertEquals(60, left[3], 1e-9);
    assertEquals(53 + 40, right[2], 1e-9);
  }

  @Test
  void ofWingsThatAreLostOnlyThatIsSaid() {
    FlyGeometry fly = new FlyGeometry(50, 60, Math.PI / 2, 40, 47, 60, 53, 60, 0.9, 0);
    double[] none = {Double.NaN, Double.NaN, Double.NaN, Double.NaN};
    Marks marks = new Marks();
    new WingOverlay()
        .draw(
            new WingSnapshot(
                0, WingTrackerState.Phase.LOST, fly, 42, none, new double[] {0.02, 0.02}),
            marks);
    assertEquals(List.of("wings lost"), marks.all);
  }

  @Test
  void aWingThatIsNotTrackedIsNotDrawn() {
    Marks marks = draw(1.5, Double.NaN);
    assertEquals(0, marks.all.stream().filter("line RIGHT"::equals).count());
  }
}
