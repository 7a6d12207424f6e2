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
 * The sensor's pixels and marks in screen resolution, drawn by the painting thread once it knows
 * the {@link #screenMapping mapping}, else here.
 */
final class SensorPicture {
  /** Number of first pictures that do not wait for fonts, which they may not need. */
  private static final int FIRST_PICTURES = 10;

  private final PixelImage image = new PixelImage();
  private final ScreenPainter painter = new ScreenPainter();
  private SensorGeometry geometry = new SensorGeometry(1, 1);
  private DisplayFrame newest = new DisplayFrame(geometry);
  private Optional<ScreenMapping> mapping = Optional.empty();
  private boolean marksVisible = true;
  private int drawn;

  SensorPicture() {
    image.setVisible(false);
    image.setSmooth(false);
  }

  /** The node of pixels and marks. */
  Node node() {
    return image;
  }

  void setGeometry(SensorGeometry newGeometry, ColourMap colours) {
    geometry = newGeometry;
    newest = new DisplayFrame(geometry);
    newest.dark = colours.dark();
    Arrays.fill(newest.pixels, colours.background() & 0xFFFFFF);
    mapping = Optional.empty();
    image.setVisible(false);
  }

  /** Positions the picture, at a number of screen pixels per unit of the view. */
  void place(Viewpoint viewpoint, double density) {
    double left = viewpoint.left();
    double top = viewpoint.top();
    double scale = viewpoint.scale();
    // only the visible part, so that a large zoom costs no more than a small one
    double fromX = Math.max(0, -left / scale);
    double fromY = Math.max(0, -top / scale);
    double toX = Math.min(geometry.width(), (viewpoint.width() - left) / scale);
    double toY = Math.min(geometry.height(), (viewpoint.height() - top) / scale);
    image.setVisible(toX > fromX && toY > fromY);
    mapping = Optional.empty();
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
    mapping =
        Optional.of(
            new ScreenMapping(
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

  /** Mapping for frames drawn by another thread; empty if nothing is visible. */
  Optional<ScreenMapping> screenMapping() {
    return mapping;
  }

  /** Sets the next frame, which must not change until there is another. */
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

  /** Redraws all, with layers over the frame and its marks. */
  void draw(Consumer<OverlayCanvas> layers) {
    if (!image.isVisible()) {
      return;
    }
    int[] shown = image.pixels();
    painter.configure(geometry, mapping.orElseThrow());
    if (newest.screenMapping.equals(mapping)) {
      System.arraycopy(newest.screen, 0, shown, 0, shown.length);
    } else {
      painter.paint(newest, shown);
    }
    layers.accept(painter.over(shown, newest.dark));
    image.repaint();
  }
}
