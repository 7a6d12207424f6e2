package haltere.ui.viewer.plots;

import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;
import javafx.scene.layout.Pane;

/**
 * Mouse and keys on a lane. The wheel, plus and minus zoom; a drag or the page keys scroll; a
 * double click or End follows the newest values. Mouse or arrow keys select a time, to which Ctrl
 * and a click, or Enter, seek. Positions are shares of the shown interval.
 */
final class PlotGestures {
  private static final double UNITS_PER_DOUBLING = 80;
  private static final double STEP = 0.01;
  private static final double STRIDE = 0.1;
  private static final double PAGE = 0.5;

  private final Pane lane;
  private final PlotPanel plots;
  private double dragX;

  private PlotGestures(Pane lane, PlotPanel plots) {
    this.lane = lane;
    this.plots = plots;
  }

  /** Lets mouse and keys work on a lane. */
  static void on(Pane lane, PlotPanel plots) {
    PlotGestures gestures = new PlotGestures(lane, plots);
    lane.setOnMouseMoved(event -> plots.point(gestures.shareAt(event.getX())));
    lane.setOnMouseExited(event -> plots.point(Double.NaN));
    lane.setOnMousePressed(gestures::pressed);
    lane.setOnMouseDragged(gestures::dragged);
    lane.setOnScroll(gestures::scrolled);
    lane.setOnKeyPressed(gestures::keyPressed);
  }

  private double shareAt(double x) {
    return LanePicture.shareAt(x, lane.getWidth());
  }

  private void pressed(MouseEvent event) {
    dragX = event.getX();
    lane.requestFocus();
    if (event.getButton() != MouseButton.PRIMARY) {
      return;
    }
    if (event.isShortcutDown()) {
      plots.goTo(shareAt(event.getX()));
    } else if (event.getClickCount() == 2) {
      plots.setFollowing(true);
    }
  }

  private void dragged(MouseEvent event) {
    plots.scroll(shareAt(dragX) - shareAt(event.getX()));
    dragX = event.getX();
    plots.point(shareAt(event.getX()));
  }

  private void scrolled(ScrollEvent event) {
    if (event.getDeltaY() != 0) {
      plots.zoom(Math.pow(2, -event.getDeltaY() / UNITS_PER_DOUBLING), shareAt(event.getX()));
      event.consume();
    }
  }

  private void keyPressed(KeyEvent event) {
    double step = event.isShiftDown() ? STRIDE : STEP;
    switch (event.getCode()) {
      case LEFT, KP_LEFT -> movePointer(-step);
      case RIGHT, KP_RIGHT -> movePointer(step);
      case PAGE_UP -> plots.scroll(-PAGE);
      case PAGE_DOWN -> plots.scroll(PAGE);
      case END -> {
        plots.point(Double.NaN);
        plots.setFollowing(true);
      }
      case PLUS, ADD, EQUALS -> plots.zoom(0.5, zoomShare());
      case MINUS, SUBTRACT -> plots.zoom(2, zoomShare());
      case ENTER -> {
        if (!Double.isNaN(plots.pointed())) {
          plots.goTo(plots.pointed());
        }
      }
      default -> {
        return;
      }
    }
    event.consume();
  }

  private double zoomShare() {
    return Double.isNaN(plots.pointed()) ? 1 : plots.pointed();
  }

  /** Moves the pointer; at an edge the plots scroll instead. */
  private void movePointer(double step) {
    double unbounded = (Double.isNaN(plots.pointed()) ? 1 : plots.pointed()) + step;
    double share = Math.max(0, Math.min(1, unbounded));
    if (share != unbounded) {
      plots.scroll(unbounded - share);
    }
    plots.point(share);
  }
}
