package haltere.ui.viewer.plots;

import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;
import javafx.scene.layout.Pane;

/**
 * What mouse and keys do on a lane of plots. The wheel, plus and minus show more or less time, a
 * drag or the pages go back, a double click or End follows again; the mouse or the arrow keys point
 * at a time, to which Ctrl and a click, or Enter, take playback. Places are shares of the time that
 * is shown.
 */
final class PlotHands {
  private static final double UNITS_PER_DOUBLING = 80;
  private static final double STEP = 0.01;
  private static final double STRIDE = 0.1;
  private static final double PAGE = 0.5;

  private final Pane lane;
  private final PlotPanel plots;
  private double dragX;

  private PlotHands(Pane lane, PlotPanel plots) {
    this.lane = lane;
    this.plots = plots;
  }

  /** Lets mouse and keys work on a lane. */
  static void on(Pane lane, PlotPanel plots) {
    PlotHands hands = new PlotHands(lane, plots);
    lane.setOnMouseMoved(event -> plots.point(hands.place(event.getX())));
    lane.setOnMouseExited(event -> plots.point(Double.NaN));
    lane.setOnMousePressed(hands::pressed);
    lane.setOnMouseDragged(hands::dragged);
    lane.setOnScroll(hands::scrolled);
    lane.setOnKeyPressed(hands::keyPressed);
  }

  private double place(double x) {
    return LanePicture.place(x, lane.getWidth());
  }

  private void pressed(MouseEvent event) {
    dragX = event.getX();
    lane.requestFocus();
    if (event.getButton() != MouseButton.PRIMARY) {
      return;
    }
    if (event.isShortcutDown()) {
      plots.goTo(place(event.getX()));
    } else if (event.getClickCount() == 2) {
      plots.setFollowing(true);
    }
  }

  private void dragged(MouseEvent event) {
    plots.scroll(place(dragX) - place(event.getX()));
    dragX = event.getX();
    plots.point(place(event.getX()));
  }

  private void scrolled(ScrollEvent event) {
    if (event.getDeltaY() != 0) {
      plots.zoom(Math.pow(2, -event.getDeltaY() / UNITS_PER_DOUBLING), place(event.getX()));
      event.consume();
    }
  }

  private void keyPressed(KeyEvent event) {
    double step = event.isShiftDown() ? STRIDE : STEP;
    switch (event.getCode()) {
      case LEFT, KP_LEFT -> pointBeside(-step);
      case RIGHT, KP_RIGHT -> pointBeside(step);
      case PAGE_UP -> plots.scroll(-PAGE);
      case PAGE_DOWN -> plots.scroll(PAGE);
      case END -> {
        plots.point(Double.NaN);
        plots.setFollowing(true);
      }
      case PLUS, ADD, EQUALS -> plots.zoom(0.5, zoomPlace());
      case MINUS, SUBTRACT -> plots.zoom(2, zoomPlace());
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

  private double zoomPlace() {
    return Double.isNaN(plots.pointed()) ? 1 : plots.pointed();
  }

  /** Points at a place beside the one before; at an edge the plots move on instead. */
  private void pointBeside(double step) {
    double wanted = (Double.isNaN(plots.pointed()) ? 1 : plots.pointed()) + step;
    double place = Math.max(0, Math.min(1, wanted));
    if (place != wanted) {
      plots.scroll(wanted - place);
    }
    plots.point(place);
  }
}
