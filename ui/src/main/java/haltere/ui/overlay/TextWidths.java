package haltere.ui.overlay;

import java.util.HashMap;
import java.util.Map;
import javafx.scene.text.Font;
import javafx.scene.text.Text;

/**
 * How wide words are in a font, quickly: the width of each character is looked up once. Pairs of
 * letters that stand nearer together make words a little narrower than that.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class TextWidths {
  private final Font font;
  private final Map<Character, Double> widths = new HashMap<>();

  TextWidths(Font font) {
    this.font = font;
  }

  /** Width of a line, units of the screen. */
  double of(String line) {
    double width = 0;
    for (int i = 0; i < line.length(); i++) {
      width += widths.computeIfAbsent(line.charAt(i), this::measured);
    }
    return width;
  }

  private double measured(char character) {
    Text text = new Text(String.valueOf(character));
    text.setFont(font);
    return text.getLayoutBounds().getWidth();
  }
}
