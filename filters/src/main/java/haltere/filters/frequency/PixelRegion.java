package haltere.filters.frequency;

/**
 * A rectangle of pixels.
 *
 * @param left first column
 * @param bottom first row, upwards
 * @param width columns, at least 1
 * @param height rows, at least 1
 * @since 0.1
 */
public record PixelRegion(int left, int bottom, int width, int height) {
  /** Checks the size. */
  public PixelRegion {
    if (width < 1 || height < 1) {
      throw new IllegalArgumentException(
          "a region has at least one pixel, not " + width + " by " + height);
    }
  }

  /**
   * The pixels between two corners, both included.
   *
   * @param x1 column of one corner
   * @param y1 row of one corner
   * @param x2 column of the other corner
   * @param y2 row of the other corner
   * @return a region
   */
  public static PixelRegion between(int x1, int y1, int x2, int y2) {
    return new PixelRegion(
        Math.min(x1, x2), Math.min(y1, y2), Math.abs(x2 - x1) + 1, Math.abs(y2 - y1) + 1);
  }

  /**
   * A pixel with its neighbours.
   *
   * @param x column
   * @param y row
   * @param reach number of neighbours at each side, 0 for the pixel alone
   * @return a square of {@code 2 reach + 1} pixels, which may extend beyond the sensor
   */
  public static PixelRegion around(int x, int y, int reach) {
    return new PixelRegion(x - reach, y - reach, 2 * reach + 1, 2 * reach + 1);
  }

  /**
   * Number of pixels.
   *
   * @return width times height
   */
  public int pixels() {
    return width * height;
  }
}
