package haltere.ui.viewer.wings;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.tracker.WingTracker;
import haltere.ui.viewer.picture.ViewTool;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import javafx.geometry.Point2D;

/**
 * Sets the fly manually: a click sets the body, a drag of the head rotates the heading, a drag of
 * the circle sets the region of interest. Settings are offsets from the estimate.
 */
final class FlyTool implements ViewTool {
  /** Position of the heading's handle, as a share of the fly's size. */
  private static final double HEAD_SHARE = 0.6;

  private static final double GRIP_SHARE = 0.15;

  private enum FlyPart {
    NONE,
    BODY,
    HEADING,
    REGION
  }

  private final Supplier<Optional<WingsView>> seen;
  private final Consumer<Function<WingTracker, WingTrackerSettings>> consumer;
  private FlyPart grip = FlyPart.NONE;
  private double atX;
  private double atY;

  /**
   * A tool on the last seen state of the tracker; the consumer gets functions to new settings, for
   * the processing thread.
   */
  FlyTool(
      Supplier<Optional<WingsView>> seen,
      Consumer<Function<WingTracker, WingTrackerSettings>> consumer) {
    this.seen = seen;
    this.consumer = consumer;
  }

  private Optional<FlyGeometry> geometry() {
    return seen.get().flatMap(WingsView::geometry);
  }

  @Override
  public String hint() {
    return "Click the body of the fly; drag its head to turn it, or the circle around it.";
  }

  @Override
  public void pressed(double x, double y) {
    dragged(x, y);
    grip = geometry().map(fly -> gripAt(fly, x, y)).orElse(FlyPart.NONE);
  }

  /** The handle of the heading. */
  private static Point2D head(FlyGeometry fly) {
    double away = HEAD_SHARE * fly.sizePx();
    double x = fly.centreX() + away * Math.cos(fly.headingRad());
    return new Point2D(x, fly.centreY() + away * Math.sin(fly.headingRad()));
  }

  private FlyPart gripAt(FlyGeometry fly, double x, double y) {
    double reach = GRIP_SHARE * fly.sizePx();
    double away = Math.hypot(x - fly.centreX(), y - fly.centreY());
    if (head(fly).distance(x, y) <= reach) {
      return FlyPart.HEADING;
    }
    double region = seen.get().map(WingsView::regionPx).orElse(0.0);
    return Math.abs(away - region) <= reach ? FlyPart.REGION : FlyPart.BODY;
  }

  @Override
  public void dragged(double x, double y) {
    atX = x;
    atY = y;
  }

  @Override
  public void released(double x, double y) {
    dragged(x, y);
    geometry().ifPresent(fly -> say(fly, x, y));
    grip = FlyPart.NONE;
  }

  private void say(FlyGeometry fly, double x, double y) {
    double heading = Math.atan2(y - fly.centreY(), x - fly.centreX());
    double radius = Math.hypot(x - fly.centreX(), y - fly.centreY());
    switch (grip) {
      case BODY -> consumer.accept(tracker -> tracker.withBodyAt(x, y));
      case HEADING -> consumer.accept(tracker -> tracker.withHeading(heading));
      case REGION -> consumer.accept(tracker -> tracker.withRegion(radius));
      case NONE -> {
        // no fly is tracked
      }
    }
  }

  @Override
  public void draw(OverlayCanvas canvas) {
    geometry().ifPresent(fly -> draw(fly, canvas));
  }

  private void draw(FlyGeometry fly, OverlayCanvas canvas) {
    MarkStyle style = MarkStyle.of(Role.LABEL);
    double x = fly.centreX();
    double y = fly.centreY();
    Point2D head = head(fly);
    switch (grip) {
      case HEADING -> canvas.line(x, y, atX, atY, style);
      case REGION -> canvas.circle(x, y, Math.hypot(atX - x, atY - y), style);
      case BODY -> canvas.circle(atX, atY, GRIP_SHARE * fly.sizePx(), style);
      case NONE -> canvas.circle(head.getX(), head.getY(), GRIP_SHARE * fly.sizePx() / 2, style);
    }
  }
}
