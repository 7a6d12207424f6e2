package haltere.ui.viewer.space;

import haltere.ui.command.terminal.Quantities;
import haltere.ui.rendering.FontLetters;
import haltere.ui.rendering.PixelOverlayCanvas;
import haltere.ui.space.BodyFlight;
import haltere.ui.space.BodyFlightDrawing;
import haltere.ui.space.SpaceView;
import haltere.ui.viewer.controls.PixelImage;
import haltere.ui.viewer.controls.RotatablePane;
import haltere.ui.viewer.controls.Theme;
import java.util.Arrays;

/** A body in space and the cameras, at one time. */
final class SpaceCanvas extends RotatablePane {
  private static final double ZOOM_PER_NOTCH = 1.2;

  private final SpaceView view = new SpaceView();
  private final PixelImage image = new PixelImage();
  private Theme theme = Theme.DARK;
  private BodyFlightDrawing drawing;
  private int index;
  private boolean fitted;

  SpaceCanvas() {
    getChildren().add(image);
    layoutBoundsProperty().subscribe((was, is) -> redraw());
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

  /** Shows a moment of a flight; the viewpoint is unchanged. */
  void show(BodyFlightDrawing newDrawing, int newIndex) {
    drawing = newDrawing;
    index = newIndex;
    redraw();
  }

  /** Draws on the background of a theme. */
  void setTheme(Theme newTheme) {
    theme = newTheme;
    redraw();
  }

  /** Shows nothing. */
  void clear() {
    drawing = null;
    goBack();
  }

  /** Resets the viewpoint. */
  @Override
  protected void goBack() {
    fitted = false;
    redraw();
  }

  private void redraw() {
    double density = PixelImage.density(this);
    int columns = (int) (getWidth() * density);
    int rows = (int) (getHeight() * density);
    if (columns < 1 || rows < 1) {
      return;
    }
    image.fit(columns, rows, density);
    Arrays.fill(image.pixels(), theme.colours().background());
    if (drawing != null) {
      if (!fitted) {
        view.fit(drawing.points(), getWidth(), getHeight());
        fitted = getWidth() > 100 && getHeight() > 100;
      }
      PixelOverlayCanvas marks = new PixelOverlayCanvas(FontLetters.ofView(density));
      marks.setTarget(image.pixels(), columns, rows);
      marks.setDark(theme.colours().dark());
      marks.setView(1, 0, getHeight(), density);
      drawing.draw(index, view, marks);
    }
    image.repaint();
  }

  static String label(BodyFlight.Moment moment) {
    var now = moment.estimate();
    return Quantities.text(
        "%.3f s   axis (%.2f, %.2f, %.2f) \u00b1 %.1f\u00b0   head %.0f\u00a0%%   used %d, rejected %d",
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
