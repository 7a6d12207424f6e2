package haltere.ui.rendering;

/**
 * Scales a picture by copying. Magnified pixels become blocks; a reduced pixel takes the colour of
 * its source pixels that differs most from the background, so that no event disappears.
 *
 * <p>Where the screen is drawn without a graphics card this is several times faster than having the
 * toolkit do it.
 */
public final class PictureScaler {
  private static final int OPAQUE = 0xFF000000;

  /** First source column of each column of the target, and at the end the one behind the last. */
  private int[] columns = {0};

  /** First source row of each row of the target, and at the end the one behind the last. */
  private int[] rows = {0};

  /** Last source column of each column of the target. */
  private int[] lastColumns = {};

  private int widest;
  private int sourceWidth;

  /**
   * Of each source column the highest of the rows that make one of the target; behind them, of each
   * the higher of that and the next column's.
   */
  private int[] combined = new int[0];

  /** Index of each column of the target in {@link #combined}, if none combines more than two. */
  private int[] positions = {};

  /**
   * Says which part is shown, by its left and top edges in pixels of the source, and how large:
   * pixels of the target per pixel of the source, above 0, and the size of the target.
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
    lastColumns = new int[width];
    positions = new int[width];
    widest = 0;
    for (int x = 0; x < width; x++) {
      lastColumns[x] = Math.max(columns[x], columns[x + 1] - 1);
      positions[x] = columns[x] + (lastColumns[x] > columns[x] ? newSourceWidth : 0);
      widest = Math.max(widest, columns[x + 1] - columns[x]);
    }
    combined = new int[2 * newSourceWidth];
  }

  private static int[] edges(double from, double scale, int count, int limit) {
    int[] edges = new int[count + 1];
    for (int i = 0; i <= count; i++) {
      // centre of a target's pixel for magnification, its edge for reduction
      double position = from + (scale >= 1 ? i + 0.5 : i) / scale;
      edges[i] = (int) Math.max(0, Math.min(limit - (i < count ? 1 : 0), Math.floor(position)));
    }
    return edges;
  }

  /**
   * Scales pixels with ranks, from {@link EventPicture#paintRanked}, to opaque ones, row by row.
   */
  public void scale(int[] ranked, int[] target) {
    int width = columns.length - 1;
    for (int y = 0; y < rows.length - 1; y++) {
      int to = y * width;
      if (y > 0 && rows[y] == rows[y - 1] && rows[y + 1] - rows[y] <= 1) {
        System.arraycopy(target, to - width, target, to, width);
      } else if (rows[y + 1] - rows[y] <= 1 && widest <= 1) {
        enlargeRow(ranked, rows[y] * sourceWidth, target, to, width);
      } else {
        reduceRow(ranked, rows[y], rows[y + 1], target, to);
      }
    }
  }

  /** Makes pixels that carry their rank opaque without scaling them. */
  public static void makeOpaque(int[] ranked, int[] target) {
    for (int i = 0; i < ranked.length; i++) {
      target[i] = ranked[i] | OPAQUE;
    }
  }

  private void enlargeRow(int[] ranked, int from, int[] target, int to, int width) {
    for (int x = 0; x < width; x++) {
      target[to + x] = ranked[from + columns[x]] | OPAQUE;
    }
  }

  private void reduceRow(int[] ranked, int fromRow, int toRow, int[] target, int to) {
    combine(ranked, fromRow, toRow);
    int width = columns.length - 1;
    if (widest <= 2) {
      combineColumns();
      for (int x = 0; x < width; x++) {
        target[to + x] = combined[positions[x]] | OPAQUE;
      }
      return;
    }
    for (int x = 0; x < width; x++) {
      int colour = Math.max(combined[columns[x]], combined[lastColumns[x]]);
      for (int column = columns[x] + 1; column < lastColumns[x]; column++) {
        colour = Math.max(colour, combined[column]);
      }
      target[to + x] = colour | OPAQUE;
    }
  }

  private void combineColumns() {
    int first = columns[0];
    int count = lastColumns[lastColumns.length - 1] - first;
    highest(combined, first, combined, first + 1, combined, sourceWidth + first, count);
  }

  /** Of each column in sight the colour of the highest rank. */
  private void combine(int[] ranked, int fromRow, int toRow) {
    int first = columns[0];
    int count = lastColumns[lastColumns.length - 1] + 1 - first;
    System.arraycopy(ranked, fromRow * sourceWidth + first, combined, first, count);
    for (int row = fromRow + 1; row < toRow; row++) {
      highest(ranked, row * sourceWidth + first, combined, first, combined, first, count);
    }
  }

  /** Separate, so that the compiler vectorises this loop. */
  private static void highest(
      int[] one, int fromOne, int[] other, int fromOther, int[] target, int to, int count) {
    for (int i = 0; i < count; i++) {
      target[to + i] = Math.max(one[fromOne + i], other[fromOther + i]);
    }
  }
}
