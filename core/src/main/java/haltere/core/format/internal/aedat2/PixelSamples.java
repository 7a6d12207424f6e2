package haltere.core.format.internal.aedat2;

import haltere.core.event.Frame;
import haltere.core.event.SensorGeometry;
import java.util.Arrays;

/** Collects the samples of a frame: each pixel has a reset sample and a later signal sample. */
final class PixelSamples {
  private static final short NONE = -1;
  private static final int UNUSED_BITS = 6;

  private final int width;
  private final int height;
  private final short[] resets;
  private final short[] signals;
  private int resetCount;
  private int signalCount;
  private int firstPixel;
  private int left;
  private int right;
  private int bottom;
  private int top;
  private long startUs;
  private long firstSignalUs;
  private long lastUs;

  PixelSamples(SensorGeometry geometry) {
    width = geometry.width();
    height = geometry.height();
    resets = new short[geometry.pixels()];
    signals = new short[geometry.pixels()];
    clear();
  }

  void clear() {
    Arrays.fill(resets, NONE);
    Arrays.fill(signals, NONE);
    resetCount = 0;
    signalCount = 0;
    left = width;
    right = -1;
    bottom = height;
    top = -1;
  }

  boolean hasReset(int x, int y) {
    return resets[y * width + x] != NONE;
  }

  /** Adds a sample; false for the signal sample of a pixel without a reset sample. */
  boolean add(int x, int y, boolean signal, int value, long timeUs) {
    int pixel = y * width + x;
    if (signal) {
      if (resets[pixel] == NONE || signals[pixel] != NONE) {
        // the recording starts within a frame: reported once, not for each pixel
        return resetCount > 0 || signalCount++ > 0;
      }
      signals[pixel] = (short) value;
      signalCount++;
      if (pixel == firstPixel) {
        firstSignalUs = timeUs;
      }
    } else {
      if (resetCount == 0) {
        clear();
        firstPixel = pixel;
        startUs = timeUs;
        firstSignalUs = timeUs;
      }
      resets[pixel] = (short) value;
      resetCount++;
      left = Math.min(left, x);
      right = Math.max(right, x);
      bottom = Math.min(bottom, y);
      top = Math.max(top, y);
    }
    lastUs = timeUs;
    return true;
  }

  boolean coversSensor() {
    return signalCount == width * height && resetCount == signalCount;
  }

  /** The frame, or null if pixels of it are missing. */
  Frame finish() {
    int frameWidth = right - left + 1;
    int frameHeight = top - bottom + 1;
    if (resetCount == 0 || signalCount != resetCount || resetCount != frameWidth * frameHeight) {
      return null;
    }
    byte[] rows = new byte[2 * resetCount];
    int at = 0;
    for (int y = top; y >= bottom; y--) {
      for (int x = left; x <= right; x++) {
        int pixel = y * width + x;
        int value = Math.max(0, resets[pixel] - signals[pixel]) << UNUSED_BITS;
        rows[at++] = (byte) value;
        rows[at++] = (byte) (value >> 8);
      }
    }
    return new Frame(
        new Frame.Times(startUs, firstSignalUs, startUs, lastUs),
        left,
        bottom,
        frameWidth,
        frameHeight,
        1,
        Frame.Depth.UNSIGNED_16,
        rows);
  }
}
