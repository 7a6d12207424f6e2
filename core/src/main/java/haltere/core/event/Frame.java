package haltere.core.event;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.Objects;

/**
 * A picture of the whole sensor or of a part of it. Pixels are addressed as events are: x to the
 * right, y up, {@code (left(), bottom())} is the sensor's pixel at the picture's lower left corner.
 *
 * <p>Thread rule: immutable.
 *
 * @since 0.1
 */
public final class Frame implements SensorSample {
  /** Data type of the values of pixels. */
  public enum Depth {
    /** Whole numbers from 0 to 255. */
    UNSIGNED_8(1, 255),
    /** Whole numbers from -128 to 127. */
    SIGNED_8(1, 127),
    /** Whole numbers from 0 to 65,535. */
    UNSIGNED_16(2, 65_535),
    /** Whole numbers from -32,768 to 32,767. */
    SIGNED_16(2, 32_767),
    /** Whole numbers of 32 bits. */
    SIGNED_32(4, Integer.MAX_VALUE),
    /** Numbers of 32 bits, white is 1. */
    FLOAT_32(4, 1),
    /** Numbers of 64 bits, white is 1. */
    FLOAT_64(8, 1);

    private final int bytes;
    private final double white;

    Depth(int bytes, double white) {
      this.bytes = bytes;
      this.white = white;
    }

    /**
     * Size of a value.
     *
     * @return bytes
     */
    public int bytes() {
      return bytes;
    }

    /**
     * The value of white.
     *
     * @return the largest whole number, or 1
     */
    public double white() {
      return white;
    }
  }

  /** Largest side, beyond that of any sensor. */
  public static final int MAX_SIDE = EventAddress.MAX_COORDINATE + 1;

  private final Times times;
  private final int left;
  private final int bottom;
  private final int width;
  private final int height;
  private final int channels;
  private final Depth depth;
  private final byte[] rows;

  /**
   * Times of a frame.
   *
   * @param exposureStartUs start of its exposure, microseconds on the source's clock
   * @param exposureEndUs end of its exposure, microseconds
   * @param readoutStartUs start of its readout, microseconds; the start of the exposure if the
   *     recording does not state it
   * @param readoutEndUs end of its readout, microseconds; the end of the exposure if the recording
   *     does not state it
   */
  public record Times(
      long exposureStartUs, long exposureEndUs, long readoutStartUs, long readoutEndUs) {
    /**
     * Times of a frame without a known readout.
     *
     * @param exposureStartUs start of its exposure, microseconds on the source's clock
     * @param exposureEndUs end of its exposure, microseconds
     */
    public Times(long exposureStartUs, long exposureEndUs) {
      this(exposureStartUs, exposureEndUs, exposureStartUs, exposureEndUs);
    }
  }

  /**
   * A frame.
   *
   * @param times of exposure and readout
   * @param left column of the sensor at the picture's left edge
   * @param bottom row of the sensor, counted upwards, at the picture's lower edge
   * @param width columns, 1 to {@link #MAX_SIDE}
   * @param height rows, 1 to {@link #MAX_SIDE}
   * @param channels 1 for grey, 3 for red, green and blue, 4 for those and opacity; 2 without a
   *     meaning of its own
   * @param depth how values are stored
   * @param rows the values: the uppermost row first, in a row from left to right, in a pixel
   *     channel by channel, little-endian; copied
   */
  public Frame(
      Times times,
      int left,
      int bottom,
      int width,
      int height,
      int channels,
      Depth depth,
      byte[] rows) {
    this.times = Objects.requireNonNull(times, "times");
    this.depth = Objects.requireNonNull(depth, "depth");
    if (width < 1 || height < 1 || width > MAX_SIDE || height > MAX_SIDE) {
      throw new IllegalArgumentException("a frame of " + width + "x" + height + " pixels");
    }
    if (channels < 1 || channels > 4) {
      throw new IllegalArgumentException("a frame has 1 to 4 channels, not " + channels);
    }
    long bytes = (long) width * height * channels * depth.bytes();
    if (rows.length != bytes) {
      throw new IllegalArgumentException(
          rows.length + " bytes for a frame that has " + bytes + " bytes of values");
    }
    this.left = left;
    this.bottom = bottom;
    this.width = width;
    this.height = height;
    this.channels = channels;
    this.rows = rows.clone();
  }

  /** {@inheritDoc} For a frame, the start of its exposure. */
  @Override
  public long timeUs() {
    return times.exposureStartUs();
  }

  @Override
  public SampleKind kind() {
    return SampleKind.FRAME;
  }

  /**
   * Times of exposure and readout.
   *
   * @return its times, microseconds
   */
  public Times times() {
    return times;
  }

  /**
   * Column of the sensor at the picture's left edge.
   *
   * @return 0 for a picture of the whole sensor
   */
  public int left() {
    return left;
  }

  /**
   * Row of the sensor at the picture's lower edge.
   *
   * @return counted upwards, 0 for a picture of the whole sensor
   */
  public int bottom() {
    return bottom;
  }

  /**
   * Number of columns.
   *
   * @return at least 1
   */
  public int width() {
    return width;
  }

  /**
   * Number of rows.
   *
   * @return at least 1
   */
  public int height() {
    return height;
  }

  /**
   * Values of a pixel.
   *
   * @return 1 for grey, 3 for red, green and blue, 4 for those and opacity
   */
  public int channels() {
    return channels;
  }

  /**
   * How values are stored.
   *
   * @return with the value of white
   */
  public Depth depth() {
    return depth;
  }

  /**
   * A value of a pixel.
   *
   * @param x column of the picture, 0 to width - 1
   * @param y row of the picture, upwards, 0 to height - 1
   * @param channel 0 to channels - 1
   * @return the value as it is stored; white is {@link Depth#white()}
   */
  public double value(int x, int y, int channel) {
    Objects.checkIndex(x, width);
    Objects.checkIndex(y, height);
    Objects.checkIndex(channel, channels);
    int at = (((height - 1 - y) * width + x) * channels + channel) * depth.bytes();
    ByteBuffer bytes = ByteBuffer.wrap(rows).order(ByteOrder.LITTLE_ENDIAN);
    return switch (depth) {
      case UNSIGNED_8 -> rows[at] & 0xff;
      case SIGNED_8 -> rows[at];
      case UNSIGNED_16 -> bytes.getShort(at) & 0xffff;
      case SIGNED_16 -> bytes.getShort(at);
      case SIGNED_32 -> bytes.getInt(at);
      case FLOAT_32 -> bytes.getFloat(at);
      case FLOAT_64 -> bytes.getDouble(at);
    };
  }

  /**
   * All values as they are stored.
   *
   * @return a read-only view: the uppermost row first, in a row from left to right, little-endian
   */
  public ByteBuffer rows() {
    return ByteBuffer.wrap(rows).asReadOnlyBuffer().order(ByteOrder.LITTLE_ENDIAN);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Frame frame
        && frame.times.equals(times)
        && frame.left == left
        && frame.bottom == bottom
        && frame.width == width
        && frame.height == height
        && frame.channels == channels
        && frame.depth == depth
        && Arrays.equals(frame.rows, rows);
  }

  @Override
  public int hashCode() {
    return 31 * times.hashCode() + Arrays.hashCode(rows);
  }

  @Override
  public String toString() {
    return width + "x" + height + "x" + channels + " " + depth + " frame at " + timeUs() + " us";
  }
}
