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
  private static final int MIN_STRIP_WIDTH = 20;

  /** Maximum share of the picture's width for the scale bar. */
  private static final double MAX_BAR_SHARE = 0.25;

  private final LinePainter painter = new LinePainter();
  private final int width;
  private final int height;
  private final int plate;
  private final int argb;

  /** Right end of the scale bar; 0 without one. */
  private int barEnd;

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
    barEnd = end + width(text) + 2 * MARGIN;
    painter.fill(0, top, barEnd, height, plate);
    write(text, end + MARGIN, top);
    int bar = top + (HEIGHT - BAR_HEIGHT) / 2;
    painter.fill(MARGIN, bar, end, bar + BAR_HEIGHT, argb);
  }

  /**
   * Draws the legend of colours into the lower right corner: beside the scale bar, which comes
   * first, or above it, with a shorter strip where there is less room, or not at all.
   */
  public void colours(ColourScale scale) {
    int texts = width(scale.first()) + width(scale.last()) + 5 * MARGIN;
    boolean above = width - texts - STRIP_WIDTH < barEnd;
    int length = Math.min(STRIP_WIDTH, width - texts);
    int strip = width - length - width(scale.last()) - 3 * MARGIN;
    int left = strip - width(scale.first()) - 2 * MARGIN;
    int top = height - HEIGHT - MARGIN - (above ? HEIGHT : 0);
    if (length < MIN_STRIP_WIDTH || top < HEIGHT) {
      return;
    }
    painter.fill(left, top, width - MARGIN, top + HEIGHT, plate);
    for (int x = 0; x < length; x++) {
      int colour = scale.gradient().colour(x / (length - 1.0));
      int bottom = top + HEIGHT - MARGIN - 2;
      painter.fill(strip + x, top + MARGIN + 2, strip + x + 1, bottom, colour);
    }
    write(scale.first(), left + MARGIN, top);
    write(scale.last(), strip + length + MARGIN, top);
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
