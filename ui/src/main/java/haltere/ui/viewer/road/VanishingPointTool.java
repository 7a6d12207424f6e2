package haltere.ui.viewer.road;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;
import haltere.ui.viewer.picture.ViewTool;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.geometry.Point2D;

/**
 * Marks the vanishing point by a click, or by the end of a drag. The mark is drawn while the tool
 * is selected.
 */
final class VanishingPointTool implements ViewTool {
  private static final double RADIUS_PX = 3;
  private static final double ARM_PX = 8;

  private final Consumer<Point2D> consumer;
  private Optional<Point2D> mark = Optional.empty();

  /** A tool that passes on the position of the button's release, in sensor coordinates. */
  VanishingPointTool(Consumer<Point2D> consumer) {
    this.consumer = consumer;
  }

  /** Sets the drawn mark, or none. */
  void show(Optional<Point2D> newMark) {
    mark = newMark;
  }

  /** The mark that is drawn. */
  Optional<Point2D> mark() {
    return mark;
  }

  @Override
  public String hint() {
    return "Click the vanishing point of the road; tracks are then in metres on the road.";
  }

  @Override
  public void pressed(double x, double y) {
    mark = Optional.of(new Point2D(x, y));
  }

  @Override
  public void dragged(double x, double y) {
    pressed(x, y);
  }

  @Override
  public void released(double x, double y) {
    consumer.accept(new Point2D(x, y));
  }

  @Override
  public void draw(OverlayCanvas canvas) {
    mark.ifPresent(
        at -> {
          MarkStyle style = MarkStyle.of(Role.REGION);
          canvas.circle(at.getX(), at.getY(), RADIUS_PX, style);
          canvas.line(at.getX() - ARM_PX, at.getY(), at.getX() + ARM_PX, at.getY(), style);
          canvas.line(at.getX(), at.getY() - ARM_PX, at.getX(), at.getY(), style);
        });
  }
}
