package haltere.core.event;

/**
 * Size of a sensor's pixel array and the corner at which its source counts rows.
 *
 * <p>Pixel x runs from 0 to {@code width - 1} to the right, y from 0 to {@code height - 1} upwards,
 * and the origin is at the centre of the bottom left pixel, whatever the source's own convention
 * was.
 *
 * @param width columns, 1 to {@link EventAddress#MAX_COORDINATE} + 1
 * @param height rows, 1 to {@link EventAddress#MAX_COORDINATE} + 1
 * @param origin the corner where the source's own coordinates start
 * @since 0.1
 */
public record SensorGeometry(int width, int height, Origin origin) {
  /** Checks the size. */
  public SensorGeometry {
    if (width < 1 || height < 1) {
      throw new IllegalArgumentException(
          "a sensor has at least 1x1 pixels, not " + width + "x" + height);
    }
    if (width > EventAddress.MAX_COORDINATE + 1 || height > EventAddress.MAX_COORDINATE + 1) {
      throw new IllegalArgumentException(
          "a sensor has at most "
              + (EventAddress.MAX_COORDINATE + 1)
              + " pixels a side, not "
              + width
              + "x"
              + height);
    }
    java.util.Objects.requireNonNull(origin, "origin");
  }

  /**
   * Geometry of a source whose own rows count upwards.
   *
   * @param width columns
   * @param height rows
   */
  public SensorGeometry(int width, int height) {
    this(width, height, Origin.BOTTOM);
  }

  /**
   * Whether a pixel lies on the sensor.
   *
   * @param x column
   * @param y row, upwards
   * @return true on the sensor
   */
  public boolean contains(int x, int y) {
    return x >= 0 && x < width && y >= 0 && y < height;
  }

  /**
   * Number of pixels.
   *
   * @return width times height
   */
  public int pixels() {
    return width * height;
  }

  /**
   * The longer side, the usual scale of sizes that are given as a share of the sensor.
   *
   * @return pixels
   */
  public int longerSide() {
    return Math.max(width, height);
  }

  @Override
  public String toString() {
    return width + "x" + height;
  }
}
