package haltere.ui.rendering;

import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

/**
 * A small built-in font of five by seven dots, capitals only, so that pictures can carry words
 * where no fonts are installed.
 */
final class PixelFont implements Letters {
  /** The letters. */
  static final PixelFont LETTERS = new PixelFont();

  private static final int WIDTH = 5;

  private static final int ROWS = 7;

  /** Side of a dot, pixels. */
  private static final int DOT = 2;

  /** Height of a letter, pixels. */
  static final int HEIGHT = ROWS * DOT;

  /** Room above and below a line, pixels. */
  private static final int MARGIN = 3;

  private static final int ADVANCE = WIDTH + 1;

  /** A character, then its seven rows from the top, each five bits as two hexadecimal digits. */
  private static final String SHAPES =
      """
      0 0E 11 13 15 19 11 0E
      1 04 0C 04 04 04 04 0E
      2 0E 11 01 02 04 08 1F
      3 1F 02 04 02 01 11 0E
      4 02 06 0A 12 1F 02 02
      5 1F 10 1E 01 01 11 0E
      6 06 08 10 1E 11 11 0E
      7 1F 01 02 04 08 08 08
      8 0E 11 11 0E 11 11 0E
      9 0E 11 11 0F 01 02 0C
      A 0E 11 11 1F 11 11 11
      B 1E 11 11 1E 11 11 1E
      C 0E 11 10 10 10 11 0E
      D 1C 12 11 11 11 12 1C
      E 1F 10 10 1E 10 10 1F
      F 1F 10 10 1E 10 10 10
      G 0E 11 10 17 11 11 0F
      H 11 11 11 1F 11 11 11
      I 0E 04 04 04 04 04 0E
      J 07 02 02 02 02 12 0C
      K 11 12 14 18 14 12 11
      L 10 10 10 10 10 10 1F
      M 11 1B 15 15 11 11 11
      N 11 11 19 15 13 11 11
      O 0E 11 11 11 11 11 0E
      P 1E 11 11 1E 10 10 10
      Q 0E 11 11 11 15 12 0D
      R 1E 11 11 1E 14 12 11
      S 0F 10 10 0E 01 01 1E
      T 1F 04 04 04 04 04 04
      U 11 11 11 11 11 11 0E
      V 11 11 11 11 11 0A 04
      W 11 11 11 15 15 1B 11
      X 11 11 0A 04 0A 11 11
      Y 11 11 0A 04 04 04 04
      Z 1F 01 02 04 08 10 1F
      . 00 00 00 00 00 0C 0C
      , 00 00 00 00 0C 04 08
      : 00 0C 0C 00 0C 0C 00
      ; 00 0C 0C 00 0C 04 08
      ! 04 04 04 04 04 00 04
      ? 0E 11 01 02 04 00 04
      - 00 00 00 1F 00 00 00
      + 00 04 04 1F 04 04 00
      = 00 00 1F 00 1F 00 00
      / 01 01 02 04 08 10 10
      % 18 19 02 04 08 13 03
      # 0A 0A 1F 0A 1F 0A 0A
      ( 02 04 08 08 08 04 02
      ) 08 04 02 02 02 04 08
      < 02 04 08 10 08 04 02
      > 08 04 02 01 02 04 08
      _ 00 00 00 00 00 00 1F
      ' 04 04 08 00 00 00 00
      * 00 04 15 0E 15 04 00
      ° 0C 12 12 0C 00 00 00
      µ 00 11 11 11 13 1D 10
      ± 04 04 1F 04 04 00 1F
      ² 0C 12 04 08 1E 00 00
      ↑ 04 0E 15 04 04 04 04
      ↓ 04 04 04 04 15 0E 04
      """;

  /** Drawn for a character that is not in the font. */
  private static final int[] BOX = {0x1F, 0x11, 0x11, 0x11, 0x11, 0x11, 0x1F};

  private static final Map<Character, int[]> GLYPHS = glyphs();

  private PixelFont() {}

  private static Map<Character, int[]> glyphs() {
    Map<Character, int[]> glyphs = new TreeMap<>();
    glyphs.put(' ', new int[ROWS]);
    SHAPES
        .lines()
        .forEach(
            line -> {
              String[] parts = line.split(" ");
              int[] rows = new int[ROWS];
              for (int row = 0; row < ROWS; row++) {
                rows[row] = Integer.parseInt(parts[row + 1], 16);
              }
              glyphs.put(parts[0].charAt(0), rows);
            });
    return java.util.Collections.unmodifiableMap(glyphs);
  }

  @Override
  public double width(String line) {
    return line.isEmpty() ? 0 : (line.length() * ADVANCE - 1) * DOT;
  }

  @Override
  public double ascent() {
    return HEIGHT + MARGIN;
  }

  @Override
  public double descent() {
    return MARGIN;
  }

  @Override
  public void draw(String line, int left, int base, Dots dots) {
    // the micro sign has no capital of its own
    String capitals = line.replace('\u03bc', '\u00b5').toUpperCase(Locale.ROOT);
    for (int i = 0; i < capitals.length(); i++) {
      char character = capitals.charAt(i) == '\u039c' ? '\u00b5' : capitals.charAt(i);
      int[] rows = GLYPHS.getOrDefault(character, BOX);
      for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH * DOT; x++) {
          if ((rows[y / DOT] >> (WIDTH - 1 - x / DOT) & 1) != 0) {
            dots.dot(left + i * ADVANCE * DOT + x, base - HEIGHT + y, 1);
          }
        }
      }
    }
  }
}
