package haltere.ui.viewer.picture;

import haltere.core.event.SensorGeometry;
import haltere.core.overlay.OverlayCanvas;
import haltere.ui.rendering.ColourMap;
import haltere.ui.rendering.FontLetters;
import haltere.ui.viewer.controls.PixelImage;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.scene.Node;

/**
 * The pixels of the sensor on the screen, and the marks over them, drawn into pixels: by the thread
 * that paints frames, once it has been told {@link #screenPlace where}, else here.
 */
final class SensorPicture {
  /** So many pictures are not kept waiting by the loading of fonts that they may not need. */
  private static final int FIRST_PICTURES = 10;

  private final PixelImage image = new PixelImage();
  private final ScreenPainter painter = new ScreenPainter();
  private SensorGeometry geometry = new SensorGeometry(1, 1);
  private DisplayFrame newest = new DisplayFrame(geometry);
  private Optional<ScreenPlace> place = Optional.empty();
  private boolean marksVisible = true;
  private int drawn;

  /** An empty picture. */
  SensorPicture() {
    image.setVisible(false);
    image.setSmooth(false);
  }

  /** The pixels with what lies over them. */
  Node node() {
    return image;
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
  void place(Viewpoint viewpoint, double density) {
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
    int columns = Math.max(1, (int) Math.ceil((toX - fromX) * scale * density - 1e-6));
    int rows = Math.max(1, (int) Math.ceil((toY - fromY) * scale * density - 1e-6));
    image.fit(columns, rows, density);
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
                FontLetters.ofView(density),
                marksVisible));
  }

  /** Where another thread may draw frames; empty where nothing is in sight. */
  Optional<ScreenPlace> screenPlace() {
    return place;
  }

  /** The frame to be drawn next, which must stay as it is until there is another. */
  void setFrame(DisplayFrame frame) {
    newest = frame;
    if (drawn < FIRST_PICTURES && ++drawn == FIRST_PICTURES) {
      FontLetters.prepare();
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
    painter.configure(geometry, place.orElseThrow());
    if (newest.screenPlace.equals(place)) {
      System.arraycopy(newest.screen, 0, shown, 0, shown.length);
    } else {
      painter.paint(newest, shown);
    }
    layers.accept(painter.over(shown, newest.dark));
    image.repaint();
  }
}
