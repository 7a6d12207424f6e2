package haltere.ui.viewer.space;

import haltere.ui.overlay.JavaFxOverlayCanvas;
import haltere.ui.rendering.ColourMap;
import haltere.ui.space.BodyFlight;
import haltere.ui.space.BodyFlightDrawing;
import haltere.ui.space.SpaceView;
import haltere.ui.viewer.controls.Theme;
import haltere.ui.viewer.controls.TurnPane;
import java.util.Locale;
import javafx.scene.canvas.Canvas;
import javafx.scene.paint.Color;

/** A body in space and the cameras that see it, at one time. */
final class SpaceCanvas extends TurnPane {
  private static final double ZOOM_PER_NOTCH = 1.2;

  private final SpaceView view = new SpaceView();
  private final Canvas canvas = new Canvas();
  private final JavaFxOverlayCanvas marks = new JavaFxOverlayCanvas(canvas.getGraphicsContext2D());
  private Color background = JavaFxOverlayCanvas.colour(ColourMap.DARK.background());
  private BodyFlightDrawing drawing;
  private int index;
  private boolean fitted;

  SpaceCanvas() {
    getChildren().add(canvas);
    canvas.widthProperty().bind(widthProperty());
    canvas.heightProperty().bind(heightProperty());
    canvas.widthProperty().subscribe((was, is) -> redraw());
    canvas.heightProperty().subscribe((was, is) -> redraw());
    setAccessibleText("The body and the cameras in space");
    setMinSize(0, 0);
  }

  @Override
  protected void turn(double rightDegrees, double downDegrees) {
    view.turn(-Math.toRadians(rightDegrees), Math.toRadians(downDegrees));
    redraw();
  }

  @Override
  protected void zoom(double notches) {
    view.zoom(Math.pow(ZOOM_PER_NOTCH, notches));
    redraw();
  }

  @Override
  protected void goBack() {
    lookAnew();
  }

  /** Shows a moment of a flight; the view stays as it was turned. */
  void show(BodyFlightDrawing newDrawing, int newIndex) {
    drawing = newDrawing;
    index = newIndex;
    redraw();
  }

  /** Draws on the background of a theme. */
  void setTheme(Theme theme) {
    background = JavaFxOverlayCanvas.colour(theme.colours().background());
    marks.setDark(theme == Theme.DARK);
    redraw();
  }

  /** Shows nothing. */
  void clear() {
    drawing = null;
    lookAnew();
  }

  /** Looks at what is shown as if nothing had been shown before. */
  void lookAnew() {
    fitted = false;
    redraw();
  }

  private void redraw() {
    var graphics = canvas.getGraphicsContext2D();
    graphics.setFill(background);
    graphics.fillRect(0, 0, canvas.getWidth(), canvas.getHeight());
    if (drawing == null) {
      return;
    }
    if (!fitted && canvas.getWidth() > 0 && canvas.getHeight() > 0) {
      view.fit(drawing.points(), canvas.getWidth(), canvas.getHeight());
      fitted = canvas.getWidth() > 100 && canvas.getHeight() > 100;
    }
    marks.begin();
    marks.setView(1, 0, canvas.getHeight());
    drawing.draw(index, view, marks);
  }

  /** A moment in words. */
  static String words(BodyFlight.Moment moment) {
    var now = moment.estimate();
    return String.format(
        Locale.ROOT,
        "%.3f s   axis (%.2f, %.2f, %.2f) \u00b1 %.1f\u00b0   head %.0f %%   used %d, rejected %d",
        now.timeUs() * 1e-6,
        now.ux(),
        now.uy(),
        now.uz(),
        Math.toDegrees(now.sdAxisRad()),
        100 * now.headProbability(),
        now.used(),
        now.rejected());
  }
}
