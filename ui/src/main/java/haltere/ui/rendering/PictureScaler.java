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
  private int[] combined = new int[0];

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
    int width = columns.length - 1;
    int[] line = source;
    int start = fromRow * sourceWidth;
    if (toRow - fromRow > 1) {
      combineRows(source, fromRow, toRow, background);
      line = combined;
      start = 0;
    }
    for (int x = 0; x < width; x++) {
      int colour = line[start + columns[x]];
      int last = line[start + Math.max(columns[x], columns[x + 1] - 1)];
      // mostly all of them are background, or there are two at most
      if (last != colour) {
        colour = stronger(colour, last, background);
      }
      for (int column = columns[x] + 1; column < columns[x + 1] - 1; column++) {
        colour = stronger(colour, line[start + column], background);
      }
      target[to + x] = colour;
    }
  }

  /** Of each column in sight the colour that differs most from the background. */
  private void combineRows(int[] source, int fromRow, int toRow, int background) {
    int first = columns[0];
    int last = Math.max(first + 1, columns[columns.length - 1]);
    if (combined.length < sourceWidth) {
      combined = new int[sourceWidth];
    }
    System.arraycopy(source, fromRow * sourceWidth + first, combined, first, last - first);
    for (int row = fromRow + 1; row < toRow; row++) {
      int start = row * sourceWidth;
      for (int column = first; column < last; column++) {
        int colour = source[start + column];
        if (colour != background) {
          combined[column] = stronger(combined[column], colour, background);
        }
      }
    }
  }

  /** Of two colours the one that differs more from the background; mostly both are it. */
  private static int stronger(int a, int b, int background) {
    if (b == background || a == b) {
      return a;
    }
    return a == background || difference(b, background) > difference(a, background) ? b : a;
  }

  private static int difference(int a, int b) {
    return Math.abs((a >> 16 & 0xFF) - (b >> 16 & 0xFF))
        + Math.abs((a >> 8 & 0xFF) - (b >> 8 & 0xFF))
        + Math.abs((a & 0xFF) - (b & 0xFF));
  }
}
