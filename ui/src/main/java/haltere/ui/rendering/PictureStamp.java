package haltere.ui.rendering;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;

/**
 * Writes the time and a scale bar into the corners of a picture.
 *
 * <p>Thread rule: one thread at a time for a picture.
 */
public final class PictureStamp {
  private static final int DOT = 2;
  private static final int MARGIN = 6;
  private static final int WORDS_HEIGHT = PixelFont.HEIGHT * DOT;
  private static final int BAR_HEIGHT = 4;

  /** Share of the picture's width that the scale bar has at the most. */
  private static final double LONGEST_BAR = 0.25;

  private PictureStamp() {}

  /** Writes words such as a time into the upper left corner. */
  public static void words(BufferedImage image, String words, boolean dark) {
    stamp(image, words, 0, 0, dark);
  }

  /**
   * Draws a bar as long as a round number of the sensor's pixels into the lower left corner; the
   * scale is pixels of the picture per pixel of the sensor.
   */
  public static void scaleBar(BufferedImage image, int scale, boolean dark) {
    int length = 1;
    for (int factor = 1; scale * factor <= LONGEST_BAR * image.getWidth(); factor *= 10) {
      for (int step : new int[] {1, 2, 5}) {
        length = scale * factor * step <= LONGEST_BAR * image.getWidth() ? factor * step : length;
      }
    }
    int wide = length * scale;
    int top = image.getHeight() - WORDS_HEIGHT - 2 * MARGIN;
    stamp(image, length + " px", wide + MARGIN, top, dark);
    Graphics2D graphics = image.createGraphics();
    graphics.setColor(ink(dark));
    graphics.fillRect(MARGIN, top + MARGIN + (WORDS_HEIGHT - BAR_HEIGHT) / 2, wide, BAR_HEIGHT);
    graphics.dispose();
  }

  private static Color ink(boolean dark) {
    return new Color(MarkColours.argb(MarkStyle.of(Role.LABEL), dark), true);
  }

  private static void stamp(BufferedImage image, String words, int left, int top, boolean dark) {
    Graphics2D graphics = image.createGraphics();
    graphics.setColor(new Color(MarkColours.plate(dark), true));
    int right = left + PixelFont.width(words, DOT) + 2 * MARGIN;
    graphics.fillRect(0, top, right, WORDS_HEIGHT + 2 * MARGIN);
    graphics.setColor(ink(dark));
    PixelFont.draw(graphics, words, left + MARGIN, top + MARGIN + WORDS_HEIGHT, DOT);
    graphics.dispose();
  }
}
