package haltere.ui.rendering;

import haltere.core.event.Frame;
import java.awt.image.BufferedImage;
import java.awt.image.WritableRaster;

/**
 * Frames as pictures. Grey frames of more than 8 bits become 16-bit pictures; all others have 8
 * bits a channel. Values are clipped to black and white.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
public final class FramePictures {
  private FramePictures() {}

  /** Draws a frame in its size; of two channels only the first. */
  public static BufferedImage draw(Frame frame) {
    int bands = frame.channels() >= 3 ? frame.channels() : 1;
    BufferedImage image = new BufferedImage(frame.width(), frame.height(), type(frame, bands));
    WritableRaster raster = image.getRaster();
    int white = bands == 1 && frame.depth().bytes() > 1 ? 0xffff : 0xff;
    double scale = white / frame.depth().white();
    for (int y = 0; y < frame.height(); y++) {
      for (int x = 0; x < frame.width(); x++) {
        for (int band = 0; band < bands; band++) {
          double value = frame.value(x, y, band) * scale;
          int sample = (int) Math.round(Math.max(0, Math.min(white, value)));
          raster.setSample(x, frame.height() - 1 - y, band, sample);
        }
      }
    }
    return image;
  }

  private static int type(Frame frame, int bands) {
    return switch (bands) {
      case 3 -> BufferedImage.TYPE_INT_RGB;
      case 4 -> BufferedImage.TYPE_INT_ARGB;
      default ->
          frame.depth().bytes() > 1 ? BufferedImage.TYPE_USHORT_GRAY : BufferedImage.TYPE_BYTE_GRAY;
    };
  }
}
