package haltere.ui.rendering;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import java.awt.image.BufferedImage;

/**
 * Writes time, scale bar and legend into the corners of a picture.
 *
 * <p>Thread rule: one thread at a time for a picture.
 */
public final class PictureStamp {
  private static final int MARGIN = 6;
  private static final int HEIGHT = 26;
  private static final int BAR_HEIGHT = 4;
  private static final int STRIP_WIDTH = 90;

  /** Maximum share of the picture's width for the scale bar. */
  private static final double MAX_BAR_SHARE = 0.25;

  private final LinePainter painter = new LinePainter();
  private final int width;
  private final int height;
  private final int plate;
  private final int argb;

  /** A stamp for a picture without transparency, dark or light. */
  public PictureStamp(BufferedImage image, boolean dark) {
    width = image.getWidth();
    height = image.getHeight();
    painter.setTarget(Pictures.pixels(image), width, height);
    plate = MarkColours.plate(dark);
    argb = MarkColours.argb(MarkStyle.of(Role.LABEL), dark);
  }

  /** Writes a text, such as a time, into the upper left corner. */
  public void label(String text) {
    painter.fill(0, 0, width(text) + 2 * MARGIN, HEIGHT, plate);
    write(text, MARGIN, 0);
  }

  /**
   * Draws a bar as long as a round number of the sensor's pixels into the lower left corner; the
   * scale is pixels of the picture per pixel of the sensor.
   */
  public void scaleBar(int scale) {
    int length = 1;
    for (int factor = 1; scale * factor <= MAX_BAR_SHARE * width; factor *= 10) {
      for (int step : new int[] {1, 2, 5}) {
        length = scale * factor * step <= MAX_BAR_SHARE * width ? factor * step : length;
      }
    }
    String text = length + " px";
    int end = MARGIN + length * scale;
    int top = height - HEIGHT;
    painter.fill(0, top, end + width(text) + 2 * MARGIN, height, plate);
    write(text, end + MARGIN, top);
    int bar = top + (HEIGHT - BAR_HEIGHT) / 2;
    painter.fill(MARGIN, bar, end, bar + BAR_HEIGHT, argb);
  }

  /** Draws the legend of colours into the lower right corner, if there is room. */
  public void colours(ColourScale scale) {
    int strip = width - STRIP_WIDTH - width(scale.last()) - 3 * MARGIN;
    int left = strip - width(scale.first()) - 2 * MARGIN;
    int top = height - HEIGHT - MARGIN;
    if (left < 0 || top < 0) {
      return;
    }
    painter.fill(left, top, width - MARGIN, top + HEIGHT, plate);
    for (int x = 0; x < STRIP_WIDTH; x++) {
      int colour = scale.gradient().colour(x / (STRIP_WIDTH - 1.0));
      int bottom = top + HEIGHT - MARGIN - 2;
      painter.fill(strip + x, top + MARGIN + 2, strip + x + 1, bottom, colour);
    }
    write(scale.first(), left + MARGIN, top);
    write(scale.last(), strip + STRIP_WIDTH + MARGIN, top);
  }

  private static int width(String text) {
    return (int) FontLetters.OF_PICTURES.width(text);
  }

  private void write(String text, int left, int top) {
    FontLetters.OF_PICTURES.draw(
        text,
        left,
        top + HEIGHT - MARGIN - 1,
        (column, row, share) -> painter.dot(column, row, argb, share));
  }
}
