package haltere.ui.viewer.picture;

import haltere.core.event.SensorGeometry;
import haltere.core.overlay.OverlayCanvas;
import haltere.ui.overlay.FontLetters;
import haltere.ui.overlay.JavaFxOverlayCanvas;
import haltere.ui.rendering.ColourMap;
import haltere.ui.rendering.PictureScaler;
import haltere.ui.viewer.controls.PixelImage;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.geometry.Rectangle2D;
import javafx.scene.Node;
import javafx.scene.canvas.Canvas;
import javafx.scene.text.Font;

/**
 * The pixels of the sensor on the screen, and the marks over them. With a graphics card the card
 * enlarges the pixels and a canvas takes the marks; without one all of it is drawn into pixels,
 * because JavaFX's own software takes several milliseconds for it: by the thread that paints
 * frames, once it has been told {@link #screenPlace where}, else here.
 */
final class SensorPicture {
  /** So many pictures are not kept waiting by the loading of letters that they may not need. */
  private static final int FIRST_PICTURES = 10;

  private final PixelImage image = new PixelImage();
  private final boolean scaleHere;
  private final ScreenPainter painter = new ScreenPainter();
  private final Canvas canvas = new Canvas();
  private final JavaFxOverlayCanvas canvasMarks =
      new JavaFxOverlayCanvas(canvas.getGraphicsContext2D());
  private FontLetters letters;
  private double density;
  private SensorGeometry geometry = new SensorGeometry(1, 1);
  private DisplayFrame newest = new DisplayFrame(geometry);
  private Optional<ScreenPlace> place = Optional.empty();
  private boolean marksVisible = true;
  private int drawn;

  /** An empty picture; without a graphics card it is scaled here. */
  SensorPicture(boolean scaleHere) {
    this.scaleHere = scaleHere;
    image.setVisible(false);
    canvas.setManaged(false);
    canvas.setMouseTransparent(true);
    canvas.setVisible(false);
  }

  /** The pixels, and what lies over them. */
  List<Node> nodes() {
    return scaleHere ? List.of(image) : List.of(image, canvas);
  }

  /** Prepares for another sensor. */
  void setGeometry(SensorGeometry newGeometry, ColourMap colours) {
    geometry = newGeometry;
    newest = new DisplayFrame(geometry);
    newest.dark = colours.dark();
    Arrays.fill(newest.pixels, colours.background() & 0xFFFFFF);
    place = Optional.empty();
    image.setVisible(false);
  }

  /** Puts the picture where it belongs, on so many pixels of the screen per unit of the view. */
  void place(Viewpoint viewpoint, double newDensity) {
    double left = viewpoint.left();
    double top = viewpoint.top();
    double scale = viewpoint.scale();
    // only what is in sight, so that a large zoom costs no more than a small one
    double fromX = Math.max(0, -left / scale);
    double fromY = Math.max(0, -top / scale);
    double toX = Math.min(geometry.width(), (viewpoint.width() - left) / scale);
    double toY = Math.min(geometry.height(), (viewpoint.height() - top) / scale);
    image.setVisible(toX > fromX && toY > fromY);
    place = Optional.empty();
    if (!image.isVisible()) {
      return;
    }
    double imageX = left + fromX * scale;
    double imageY = top + fromY * scale;
    double bottom = top + geometry.height() * scale;
    image.setX(imageX);
    image.setY(imageY);
    if (scaleHere) {
      if (density != newDensity) {
        density = newDensity;
        letters = new FontLetters(Font.font(JavaFxOverlayCanvas.FONT_SIZE), density);
      }
      int columns = Math.max(1, (int) Math.ceil((toX - fromX) * scale * density - 1e-6));
      int rows = Math.max(1, (int) Math.ceil((toY - fromY) * scale * density - 1e-6));
      image.allocate(columns, rows);
      image.setSmooth(false);
      image.setFitWidth(columns / density);
      image.setFitHeight(rows / density);
      place =
          Optional.of(
              new ScreenPlace(
                  fromX,
                  fromY,
                  scale,
                  density,
                  columns,
                  rows,
                  left - imageX,
                  bottom - imageY,
                  letters,
                  marksVisible));
    } else {
      image.allocate(geometry.width(), geometry.height());
      image.setSmooth(scale * newDensity < 1);
      image.setViewport(new Rectangle2D(fromX, fromY, toX - fromX, toY - fromY));
      image.setFitWidth((toX - fromX) * scale);
      image.setFitHeight((toY - fromY) * scale);
      // a canvas costs by its size
      canvas.relocate(imageX, imageY);
      canvas.setWidth((toX - fromX) * scale);
      canvas.setHeight((toY - fromY) * scale);
      canvasMarks.setView(scale, left - imageX, bottom - imageY);
    }
  }

  /**
   * Where another thread may draw frames; empty where a graphics card does it, nothing is in sight,
   * or letters are still to be loaded.
   */
  Optional<ScreenPlace> screenPlace() {
    return letters != null && letters.isLoaded() ? place : Optional.empty();
  }

  /** The frame to be drawn next, which must stay as it is until there is another. */
  void setFrame(DisplayFrame frame) {
    newest = frame;
    if (letters != null && drawn < FIRST_PICTURES && ++drawn == FIRST_PICTURES) {
      letters.load();
    }
  }

  /** Whether marks of filters are drawn, from the next {@link #place} on. */
  void setMarksVisible(boolean visible) {
    marksVisible = visible;
  }

  /** Draws all anew, with what lies over the frame and its marks. */
  void draw(Consumer<OverlayCanvas> layers) {
    if (!image.isVisible()) {
      return;
    }
    int[] shown = image.pixels();
    if (scaleHere) {
      drawPixels(place.orElseThrow(), shown, layers);
    } else {
      PictureScaler.makeOpaque(newest.pixels, shown);
      drawOnCanvas(layers);
    }
    image.repaint();
  }

  private void drawPixels(ScreenPlace there, int[] shown, Consumer<OverlayCanvas> layers) {
    painter.configure(geometry, there);
    if (newest.screenPlace.equals(place)) {
      System.arraycopy(newest.screen, 0, shown, 0, shown.length);
    } else {
      painter.paint(newest, shown);
    }
    layers.accept(painter.over(shown, newest.dark));
  }

  private void drawOnCanvas(Consumer<OverlayCanvas> layers) {
    if (canvas.isVisible()) {
      canvas.getGraphicsContext2D().clearRect(0, 0, canvas.getWidth(), canvas.getHeight());
    }
    canvasMarks.begin();
    canvasMarks.setDark(newest.dark);
    long before = canvasMarks.marks();
    if (marksVisible) {
      newest.marks.forEach(snapshot -> snapshot.draw(newest.timeUs, canvasMarks));
    }
    layers.accept(canvasMarks);
    canvas.setVisible(canvasMarks.marks() != before);
  }
}
