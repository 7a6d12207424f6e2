package haltere.ui.rendering;

import java.util.Arrays;

/**
 * Colours with a rank in place of their opacity, 0 for the background to 127 for the largest
 * difference from it. Of two colours, the larger number has priority.
 */
final class ColourRanks {
  private static final int MAX_RANK = 127;
  private static final int FARTHEST = 3 * 255;

  private ColourRanks() {}

  /** A colour with its rank. */
  static int ranked(int rgb, int background) {
    int difference =
        Math.abs((rgb >> 16 & 0xFF) - (background >> 16 & 0xFF))
            + Math.abs((rgb >> 8 & 0xFF) - (background >> 8 & 0xFF))
            + Math.abs((rgb & 0xFF) - (background & 0xFF));
    return difference * MAX_RANK / FARTHEST << 24 | rgb & 0xFFFFFF;
  }

  /** Gives each colour of a table its rank. */
  static void rank(int[] table, int background) {
    Arrays.setAll(table, i -> ranked(table[i], background));
  }
}
