package haltere.ui.viewer.road;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;
import haltere.ui.viewer.picture.ViewTool;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javafx.geometry.Point2D;

/**
 * Marks points in a fixed order, each by a click or by the end of a drag; a click after the last
 * point moves it. The points are drawn while the tool is selected: one as a cross, several as the
 * numbered corners of a polygon.
 */
final class PointsTool implements ViewTool {
  private static final double RADIUS_PX = 3;
  private static final double ARM_PX = 8;
  private static final double STEPS_PER_PX = 10;

  private final Consumer<List<Point2D>> consumer;
  private final List<String> hints;
  private final List<Point2D> points = new ArrayList<>();

  /**
   * A tool with a hint for each point. The consumer gets the present points after each change by
   * the user, in sensor coordinates in steps of 0.1 px.
   */
  PointsTool(Consumer<List<Point2D>> consumer, String... hints) {
    this.consumer = consumer;
    this.hints = List.of(hints);
  }

  /** Sets the drawn points. */
  void show(List<Point2D> newPoints) {
    points.clear();
    points.addAll(newPoints);
  }

  /** The points that are drawn. */
  List<Point2D> points() {
    return List.copyOf(points);
  }

  @Override
  public String hint() {
    return hints.get(Math.min(points.size(), hints.size() - 1));
  }

  @Override
  public void pressed(double x, double y) {
    if (points.size() < hints.size()) {
      points.add(Point2D.ZERO);
    }
    dragged(x, y);
  }

  @Override
  public void dragged(double x, double y) {
    removeLast();
    points.add(
        new Point2D(
            Math.rint(x * STEPS_PER_PX) / STEPS_PER_PX,
            Math.rint(y * STEPS_PER_PX) / STEPS_PER_PX));
  }

  private void removeLast() {
    points.subList(Math.max(0, points.size() - 1), points.size()).clear();
  }

  @Override
  public void released(double x, double y) {
    dragged(x, y);
    consumer.accept(points());
  }

  @Override
  public boolean takeBack() {
    boolean isTaken = hints.size() > 1 && !points.isEmpty();
    if (isTaken) {
      removeLast();
      consumer.accept(points());
    }
    return isTaken;
  }

  @Override
  public void draw(OverlayCanvas canvas) {
    MarkStyle style = MarkStyle.of(Role.REGION);
    boolean isPolygon = hints.size() > 1;
    for (int i = 0; i < points.size(); i++) {
      double x = points.get(i).getX();
      double y = points.get(i).getY();
      canvas.circle(x, y, RADIUS_PX, style);
      if (isPolygon) {
        canvas.text(x + RADIUS_PX, y + RADIUS_PX, "" + (i + 1), MarkStyle.of(Role.LABEL));
      } else {
        canvas.line(x - ARM_PX, y, x + ARM_PX, y, style);
        canvas.line(x, y - ARM_PX, x, y, style);
      }
      if (i > 0 || points.size() == hints.size()) {
        Point2D before = points.get(Math.floorMod(i - 1, points.size()));
        canvas.line(before.getX(), before.getY(), x, y, style);
      }
    }
  }
}
