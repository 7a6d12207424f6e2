package haltere.ui.rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class FontLettersTest {
  private static List<String> drawn(Letters letters, String text) {
    List<String> dots = new ArrayList<>();
    letters.draw(text, 0, 20, (column, row, share) -> dots.add(column + "," + row));
    return dots;
  }

  @Test
  void allCharactersOfOverlaysHaveGlyphs() {
    List<String> unknown = drawn(FontLetters.OF_PICTURES, "\uffff");
    for (String letter : "20m:\u2191\u2193,54\u00b1km/hHz\u00b0\u00b5".split("")) {
      assertNotEquals(unknown, drawn(FontLetters.OF_PICTURES, letter), letter);
    }
  }

  @Test
  void lettersLieBetweenAscentAndBaseline() {
    Letters letters = FontLetters.ofView(2);
    assertTrue(letters.width("wider") > letters.width("wide"));
    for (String dot : drawn(letters, "x")) {
      int row = Integer.parseInt(dot.split(",")[1]);
      assertTrue(row >= 20 - letters.ascent() && row <= 20, "row " + row);
    }
  }

  @Test
  void textIsOmittedWithoutAFont() {
    Letters letters =
        new FontLetters(
            12,
            () -> {
              // what Java throws where the system has no font configuration
              throw new InternalError("Fontconfig head is null");
            });
    assertEquals(0, letters.width("anything"));
    assertEquals(List.of(), drawn(letters, "anything"));
  }
}
