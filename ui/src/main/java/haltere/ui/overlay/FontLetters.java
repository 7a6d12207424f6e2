package haltere.ui.overlay;

import haltere.ui.rendering.Letters;
import java.util.HashMap;
import java.util.Map;
import javafx.geometry.Rectangle2D;
import javafx.geometry.VPos;
import javafx.scene.Group;
import javafx.scene.Scene;
import javafx.scene.SnapshotParameters;
import javafx.scene.image.PixelReader;
import javafx.scene.image.WritableImage;
import javafx.scene.paint.Color;
import javafx.scene.text.Font;
import javafx.scene.text.Text;
import javafx.scene.transform.Scale;

/**
 * The letters of the window's font, drawn by JavaFX once, all together, when the first words come,
 * and copied from then on. What is in no word of the program is drawn as a question mark.
 *
 * <p>Thread rule: JavaFX thread only until {@link #isLoaded() they are loaded}.
 */
public final class FontLetters implements Letters {
  private static final String MORE =
      "\u00b0\u00b1\u00b2\u00b3\u00b5\u00b7\u00d7\u2013\u2026\u2212\u2191\u2193";

  /** Room around each letter, because some stick out of their width. */
  private static final int MARGIN = 2;

  private record Letter(double advance, int width, int height, float[] shares) {}

  private final Font font;
  private final double density;
  private final double ascent;
  private final double descent;
  private Map<Character, Letter> letters = Map.of();

  /**
   * Letters of a font with its size in units of the window, for so many pixels of the screen per
   * unit.
   */
  public FontLetters(Font font, double density) {
    this.font = font;
    this.density = density;
    Text tall = text("Ag");
    ascent = Math.rint((tall.getBaselineOffset() + 1) * density);
    descent = Math.rint((tall.getLayoutBounds().getHeight() - tall.getBaselineOffset()) * density);
  }

  private Text text(String words) {
    Text text = new Text(words);
    text.setFont(font);
    text.setTextOrigin(VPos.BASELINE);
    text.setFill(Color.WHITE);
    return text;
  }

  @Override
  public double width(String line) {
    load();
    double width = 0;
    for (int i = 0; i < line.length(); i++) {
      width += letter(line.charAt(i)).advance();
    }
    return width;
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
    load();
    double place = left;
    int top = base - (int) ascent;
    for (int i = 0; i < line.length(); i++) {
      Letter letter = letter(line.charAt(i));
      int from = (int) Math.rint(place) - MARGIN;
      for (int y = 0; y < letter.height(); y++) {
        for (int x = 0; x < letter.width(); x++) {
          float share = letter.shares()[y * letter.width() + x];
          if (share > 0) {
            dots.dot(from + x, top + y, share);
          }
        }
      }
      place += letter.advance();
    }
  }

  private Letter letter(char character) {
    Letter known = letters.get(character);
    return known != null ? known : letters.get('?');
  }

  /** Whether the letters have been drawn; from then on any thread may copy them. */
  public boolean isLoaded() {
    return !letters.isEmpty();
  }

  /** Draws the letters if that has not been done. */
  public void load() {
    if (!letters.isEmpty()) {
      return;
    }
    StringBuilder all = new StringBuilder(MORE);
    for (char character = ' '; character < 127; character++) {
      all.append(character);
    }
    int height = (int) (ascent + descent);
    int[] lefts = new int[all.length() + 1];
    double[] advances = new double[all.length()];
    Group row = new Group();
    for (int i = 0; i < all.length(); i++) {
      Text letter = text(all.substring(i, i + 1));
      advances[i] = letter.getLayoutBounds().getWidth() * density;
      letter.getTransforms().add(new Scale(density, density));
      letter.setX((lefts[i] + MARGIN) / density);
      letter.setY(ascent / density);
      row.getChildren().add(letter);
      lefts[i + 1] = lefts[i] + (int) Math.ceil(advances[i]) + 2 * MARGIN;
    }
    WritableImage image = picture(row, lefts[all.length()], height);
    Map<Character, Letter> loaded = new HashMap<>();
    for (int i = 0; i < all.length(); i++) {
      int width = lefts[i + 1] - lefts[i];
      float[] shares = shares(image.getPixelReader(), lefts[i], width, height);
      loaded.put(all.charAt(i), new Letter(advances[i], width, height, shares));
    }
    letters = loaded;
  }

  private static WritableImage picture(Group row, int width, int height) {
    new Scene(row);
    SnapshotParameters parameters = new SnapshotParameters();
    parameters.setFill(Color.TRANSPARENT);
    parameters.setViewport(new Rectangle2D(0, 0, width, height));
    return row.snapshot(parameters, new WritableImage(width, height));
  }

  private static float[] shares(PixelReader pixels, int left, int width, int height) {
    float[] shares = new float[width * height];
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        shares[y * width + x] = (pixels.getArgb(left + x, y) >>> 24) / 255f;
      }
    }
    return shares;
  }
}
