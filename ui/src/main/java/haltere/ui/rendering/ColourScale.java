package haltere.ui.rendering;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Objects;
import java.util.Optional;

/**
 * What the ends of a gradient stand for, where colours stand for ages or counts.
 *
 * <p>Thread rule: immutable; a picture is drawn on by one thread at a time.
 *
 * @param gradient the colours
 * @param first what the first colour stands for, in words
 * @param last what the last colour stands for, in words
 */
public record ColourScale(Gradient gradient, String first, String last) {
  private static final int DOT = 2;
  private static final int MARGIN = 6;
  private static final int STRIP = 90;
  private static final int WORDS_HEIGHT = PixelFont.HEIGHT * DOT;

  /** Checks that nothing is missing. */
  public ColourScale {
    Objects.requireNonNull(gradient, "gradient");
    Objects.requireNonNull(first, "first");
    Objects.requireNonNull(last, "last");
  }

  /**
   * The scale of a mode whose colours stand for ages or counts, by the highest of them in words;
   * empty for other modes, and where that is not known.
   */
  public static Optional<ColourScale> of(DisplayMode mode, Gradient gradient, String farEnd) {
    if (farEnd.isEmpty()) {
      return Optional.empty();
    }
    return switch (mode) {
      case TIME_SURFACE -> Optional.of(new ColourScale(gradient, farEnd, "now"));
      case COUNTS -> Optional.of(new ColourScale(gradient, "0", farEnd));
      case FREQUENCY -> Optional.of(new ColourScale(gradient, "5 Hz", farEnd));
      default -> Optional.empty();
    };
  }

  /**
   * Draws the scale into the lower right corner of a picture; not at all where that has no room.
   */
  public void draw(BufferedImage image, boolean dark) {
    int firstWidth = PixelFont.width(first, DOT);
    int lastWidth = PixelFont.width(last, DOT);
    int width = firstWidth + STRIP + lastWidth + 4 * MARGIN;
    int height = WORDS_HEIGHT + 2 * MARGIN;
    int left = image.getWidth() - width - MARGIN;
    int top = image.getHeight() - height - MARGIN;
    if (left < 0 || top < 0) {
      return;
    }
    Graphics2D graphics = image.createGraphics();
    try {
      graphics.setColor(new Color(MarkColours.plate(dark), true));
      graphics.fillRect(left, top, width, height);
      int strip = left + 2 * MARGIN + firstWidth;
      for (int x = 0; x < STRIP; x++) {
        graphics.setColor(new Color(gradient.colour(x / (STRIP - 1.0))));
        graphics.fillRect(strip + x, top + MARGIN + 2, 1, WORDS_HEIGHT - 4);
      }
      int base = top + MARGIN + WORDS_HEIGHT;
      graphics.setColor(new Color(MarkColours.argb(MarkStyle.of(Role.LABEL), dark), true));
      PixelFont.draw(graphics, first, left + MARGIN, base, DOT);
      PixelFont.draw(graphics, last, strip + STRIP + MARGIN, base, DOT);
    } finally {
      graphics.dispose();
    }
  }
}
