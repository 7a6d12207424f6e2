package haltere.ui.rendering;

/**
 * Scales a picture to the size at which it is shown, by plain copying: enlarged, each pixel becomes
 * a block of its colour; reduced, each pixel takes that of the pixels it stands for which differs
 * most from the background, so that no event disappears between two lines.
 *
 * <p>Where the screen is drawn without a graphics card this is several times faster than having the
 * toolkit do it.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class PictureScaler {
  /** First source column of each column of the target, and at the end the one behind the last. */
  private int[] columns = {0};

  /** First source row of each row of the target, and at the end the one behind the last. */
  private int[] rows = {0};

  private int sourceWidth;

  /**
   * Says which part is shown and how large.
   *
   * @param newSourceWidth width of the source's rows
   * @param sourceHeight its rows
   * @param fromX left edge of the part, in pixels of the source
   * @param fromY top edge of the part
   * @param scale pixels of the target per pixel of the source, above 0
   * @param width of the target
   * @param height of the target
   */
  public void configure(
      int newSourceWidth,
      int sourceHeight,
      double fromX,
      double fromY,
      double scale,
      int width,
      int height) {
    sourceWidth = newSourceWidth;
    columns = edges(fromX, scale, width, newSourceWidth);
    rows = edges(fromY, scale, height, sourceHeight);
  }

  private static int[] edges(double from, double scale, int count, int limit) {
    int[] edges = new int[count + 1];
    for (int i = 0; i <= count; i++) {
      // the middle of a target's pixel decides when enlarging, its edge when reducing
      double place = from + (scale >= 1 ? i + 0.5 : i) / scale;
      edges[i] = (int) Math.max(0, Math.min(limit - (i < count ? 1 : 0), Math.floor(place)));
    }
    return edges;
  }

  /**
   * Scales.
   *
   * @param source ARGB pixels, row by row
   * @param background the colour that matters least
   * @param target receives the pixels, row by row
   */
  public void scale(int[] source, int background, int[] target) {
    int width = columns.length - 1;
    for (int y = 0; y < rows.length - 1; y++) {
      int to = y * width;
      if (y > 0 && rows[y] == rows[y - 1] && rows[y + 1] - rows[y] <= 1) {
        System.arraycopy(target, to - width, target, to, width);
      } else if (rows[y + 1] - rows[y] <= 1 && columns[width] - columns[0] <= width) {
        enlargeRow(source, rows[y] * sourceWidth, target, to, width);
      } else {
        reduceRow(source, rows[y], Math.max(rows[y] + 1, rows[y + 1]), background, target, to);
      }
    }
  }

  private void enlargeRow(int[] source, int from, int[] target, int to, int width) {
    for (int x = 0; x < width; x++) {
      target[to + x] = source[from + columns[x]];
    }
  }

  private void reduceRow(
      int[] source, int fromRow, int toRow, int background, int[] target, int to) {
    for (int x = 0; x < columns.length - 1; x++) {
      int best = background;
      int bestDifference = -1;
      int end = Math.max(columns[x] + 1, columns[x + 1]);
      for (int row = fromRow; row < toRow; row++) {
        for (int column = columns[x]; column < end; column++) {
          int colour = source[row * sourceWidth + column];
          int difference = difference(colour, background);
          if (difference > bestDifference) {
            best = colour;
            bestDifference = difference;
          }
        }
      }
      target[to + x] = best;
    }
  }

  private static int difference(int a, int b) {
    return a == b
        ? 0
        : Math.abs((a >> 16 & 0xFF) - (b >> 16 & 0xFF))
            + Math.abs((a >> 8 & 0xFF) - (b >> 8 & 0xFF))
            + Math.abs((a & 0xFF) - (b & 0xFF));
  }
}
