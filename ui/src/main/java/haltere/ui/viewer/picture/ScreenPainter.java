package haltere.ui.viewer.picture;

import haltere.core.event.SensorGeometry;
import haltere.core.overlay.OverlayCanvas;
import haltere.ui.rendering.OverlaySnapshots;
import haltere.ui.rendering.PictureScaler;
import haltere.ui.rendering.PixelOverlayCanvas;

/**
 * Draws frames in screen resolution, pixels and marks.
 *
 * <p>Thread rule: one thread at a time.
 */
final class ScreenPainter {
  private final PictureScaler scaler = new PictureScaler();
  private PixelOverlayCanvas canvas;
  private ScreenMapping mapping;
  private SensorGeometry geometry;

  /** Sets the visible part. */
  void configure(SensorGeometry newGeometry, ScreenMapping newMapping) {
    if (newMapping.equals(mapping) && newGeometry.equals(geometry)) {
      return;
    }
    if (mapping == null || newMapping.letters() != mapping.letters()) {
      canvas = new PixelOverlayCanvas(newMapping.letters());
    }
    mapping = newMapping;
    geometry = newGeometry;
    scaler.configure(
        geometry.width(),
        geometry.height(),
        mapping.fromX(),
        mapping.fromY(),
        mapping.scale() * mapping.density(),
        mapping.columns(),
        mapping.rows());
    canvas.setView(mapping.scale(), mapping.left(), mapping.bottom(), mapping.density());
  }

  /** Draws the pixels and marks of a frame, as many opaque pixels as the mapping has. */
  void paint(DisplayFrame frame, int[] target) {
    scaler.scale(frame.pixels, target);
    if (mapping.marks()) {
      OverlayCanvas over = over(target, frame.dark);
      for (OverlaySnapshots.Marks<?> snapshot : frame.marks) {
        snapshot.draw(frame.timeUs, over);
      }
    }
  }

  /** A canvas over pixels that have been painted. */
  OverlayCanvas over(int[] target, boolean dark) {
    canvas.setTarget(target, mapping.columns(), mapping.rows());
    canvas.setDark(dark);
    return canvas;
  }
}
