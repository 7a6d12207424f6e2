package haltere.ui.rendering;

import haltere.core.stream.internal.Daemon;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.font.FontRenderContext;
import java.awt.font.LineMetrics;
import java.awt.image.BufferedImage;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;

/**
 * Bold letters of the platform's sans-serif font, drawn once and cached. Without an installed font,
 * text is omitted.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
public final class FontLetters implements Letters {
  /** Letters of pictures and films, 16 pixels high. */
  public static final FontLetters OF_PICTURES = new FontLetters(16);

  /** Font size over a view, units of the view. */
  private static final double VIEW_SIZE = 12;

  private static final Map<Double, FontLetters> OF_VIEWS = new ConcurrentHashMap<>();

  /** Room around each letter, because some stick out of their width. */
  private static final int MARGIN = 2;

  private record Letter(double advance, int width, int[] argb) {}

  /** A font, null if there is none, with its extents above and below a line, pixels. */
  private record Face(Font font, double ascent, double descent) {}

  private static final FontRenderContext CONTEXT = new FontRenderContext(null, true, false);

  private final Supplier<Font> source;
  private final double sizePx;
  private final Map<Character, Letter> letters = new ConcurrentHashMap<>();
  private volatile Face face;

  private FontLetters(double sizePx) {
    this(sizePx, () -> new Font(Font.SANS_SERIF, Font.BOLD, 1).deriveFont((float) sizePx));
  }

  FontLetters(double sizePx, Supplier<Font> source) {
    this.sizePx = sizePx;
    this.source = source;
  }

  /** Letters over a view, with its pixels of the screen per unit. */
  public static FontLetters ofView(double density) {
    return OF_VIEWS.computeIfAbsent(density, each -> new FontLetters(VIEW_SIZE * each));
  }

  /**
   * Loads the fonts on a separate thread before text is drawn, which takes a fraction of a second.
   */
  public static void prepare() {
    Daemon.thread(() -> OF_PICTURES.width("0"), "haltere-letters").start();
  }

  private Face face() {
    if (face == null) {
      face = load();
    }
    return face;
  }

  private Face load() {
    try {
      Font font = source.get();
      LineMetrics metrics = font.getLineMetrics("Ag", CONTEXT);
      // margin above the letters
      double ascent = Math.rint(metrics.getAscent() + sizePx / 12);
      return new Face(font, ascent, Math.rint(metrics.getDescent()));
    } catch (RuntimeException | InternalError | LinkageError noFonts) {
      // Java finds no fonts here, or no library that draws them
      return new Face(null, sizePx, 0);
    }
  }

  @Override
  public double width(String line) {
    return line.chars().mapToDouble(character -> letter((char) character).advance).sum();
  }

  @Override
  public double ascent() {
    return face().ascent;
  }

  @Override
  public double descent() {
    return face().descent;
  }

  @Override
  public void draw(String line, int left, int base, Dots dots) {
    double x = left;
    for (int i = 0; i < line.length(); i++) {
      Letter letter = letter(line.charAt(i));
      int from = (int) Math.rint(x) - MARGIN;
      for (int k = 0; k < letter.argb.length; k++) {
        if (letter.argb[k] != 0) {
          int row = base - (int) ascent() + k / letter.width;
          dots.dot(from + k % letter.width, row, (letter.argb[k] >>> 24) / 255.0);
        }
      }
      x += letter.advance;
    }
  }

  private Letter letter(char character) {
    return letters.computeIfAbsent(character, this::drawn);
  }

  private Letter drawn(char character) {
    Font font = face().font;
    if (font == null) {
      return new Letter(0, 1, new int[0]);
    }
    String text = String.valueOf(character);
    double advance = font.getStringBounds(text, CONTEXT).getWidth();
    int width = (int) Math.ceil(advance) + 2 * MARGIN;
    int height = (int) (ascent() + descent());
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
    Graphics2D graphics = image.createGraphics();
    graphics.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    graphics.setFont(font);
    graphics.drawString(text, MARGIN, (int) ascent());
    graphics.dispose();
    return new Letter(advance, width, image.getRGB(0, 0, width, height, null, 0, width));
  }
}
