package haltere.ui.viewer.picture;

import haltere.core.event.SensorGeometry;
import haltere.core.overlay.OverlayCanvas;
import haltere.ui.rendering.LayerTaps;
import haltere.ui.rendering.PictureScaler;
import haltere.ui.rendering.PixelOverlayCanvas;

/**
 * Draws frames as they are on the screen, pixels and marks.
 *
 * <p>Thread rule: one thread at a time.
 */
final class ScreenPainter {
  private final PictureScaler scaler = new PictureScaler();
  private PixelOverlayCanvas canvas;
  private ScreenPlace place;
  private SensorGeometry geometry;

  /** Says what is in sight. */
  void configure(SensorGeometry newGeometry, ScreenPlace newPlace) {
    if (newPlace.equals(place) && newGeometry.equals(geometry)) {
      return;
    }
    if (place == null || newPlace.letters() != place.letters()) {
      canvas = new PixelOverlayCanvas(newPlace.letters());
    }
    place = newPlace;
    geometry = newGeometry;
    scaler.configure(
        geometry.width(),
        geometry.height(),
        place.fromX(),
        place.fromY(),
        place.scale() * place.density(),
        place.columns(),
        place.rows());
    canvas.setView(place.scale(), place.left(), place.bottom(), place.density());
  }

  /** Draws the pixels and marks of a frame, as many opaque pixels as the place has. */
  void paint(DisplayFrame frame, int[] target) {
    scaler.scale(frame.pixels, target);
    if (place.marks()) {
      OverlayCanvas over = over(target, frame.dark);
      for (LayerTaps.Marks<?> snapshot : frame.marks) {
        snapshot.draw(frame.timeUs, over);
      }
    }
  }

  /** A canvas over pixels that have been painted. */
  OverlayCanvas over(int[] target, boolean dark) {
    canvas.setTarget(target, place.columns(), place.rows());
    canvas.setDark(dark);
    return canvas;
  }
}
