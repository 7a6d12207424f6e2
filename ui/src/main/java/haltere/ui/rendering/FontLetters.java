package haltere.ui.rendering;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.font.FontRenderContext;
import java.awt.font.LineMetrics;
import java.awt.image.BufferedImage;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * The bold letters of the platform's sans-serif font, to be read over events, each drawn once and
 * copied from then on. Where no font is installed words are left out.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
public final class FontLetters implements Letters {
  /** Letters of pictures and films, 16 pixels high. */
  public static final FontLetters OF_PICTURES = new FontLetters(16);

  /** Size of words over a view, units of the view. */
  private static final double VIEW_SIZE = 12;

  private static final Map<Double, FontLetters> OF_VIEWS = new ConcurrentHashMap<>();

  /** Room around each letter, because some stick out of their width. */
  private static final int MARGIN = 2;

  private record Letter(double advance, int width, int[] argb) {}

  private final double ascent;
  private final double descent;
  private final Font font;
  private final FontRenderContext context = new FontRenderContext(null, true, true);
  private final Map<Character, Letter> letters = new ConcurrentHashMap<>();

  /** Letters over a view that has so many pixels of the screen per unit. */
  public static FontLetters ofView(double density) {
    return OF_VIEWS.computeIfAbsent(density, each -> new FontLetters(VIEW_SIZE * each));
  }

  private FontLetters(double sizePx) {
    this(sizePx, new Font(Font.SANS_SERIF, Font.BOLD, 1).deriveFont((float) sizePx));
  }

  FontLetters(double sizePx, Font font) {
    LineMetrics metrics = null;
    try {
      metrics = font.getLineMetrics("Ag", context);
    } catch (RuntimeException | InternalError | LinkageError noFonts) {
      // Java finds no fonts here, or no library that draws them
    }
    this.font = metrics == null ? null : font;
    // a pixel of air above the letters of a window
    ascent = Math.rint(metrics == null ? sizePx : metrics.getAscent() + sizePx / 12);
    descent = Math.rint(metrics == null ? 0 : metrics.getDescent());
  }

  @Override
  public double width(String line) {
    return line.chars().mapToDouble(character -> letter((char) character).advance).sum();
  }

  @Override
  public double ascent() {
    return ascent;
  }

  @Override
  public double descent() {
    return descent;
  }

  @Override
  public void draw(String line, int left, int base, Dots dots) {
    double place = left;
    for (int i = 0; i < line.length(); i++) {
      Letter letter = letter(line.charAt(i));
      int from = (int) Math.rint(place) - MARGIN;
      for (int k = 0; k < letter.argb.length; k++) {
        if (letter.argb[k] != 0) {
          int row = base - (int) ascent + k / letter.width;
          dots.dot(from + k % letter.width, row, (letter.argb[k] >>> 24) / 255.0);
        }
      }
      place += letter.advance;
    }
  }

  private Letter letter(char character) {
    return letters.computeIfAbsent(character, this::drawn);
  }

  private Letter drawn(char character) {
    if (font == null) {
      return new Letter(0, 1, new int[0]);
    }
    String text = String.valueOf(character);
    double advance = font.getStringBounds(text, context).getWidth();
    int width = (int) Math.ceil(advance) + 2 * MARGIN;
    int height = (int) (ascent + descent);
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
    Graphics2D graphics = image.createGraphics();
    graphics.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    graphics.setFont(font);
    graphics.drawString(text, MARGIN, (int) ascent);
    graphics.dispose();
    return new Letter(advance, width, image.getRGB(0, 0, width, height, null, 0, width));
  }
}
