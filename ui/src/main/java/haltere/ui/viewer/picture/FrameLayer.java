package haltere.ui.viewer.picture;

import haltere.core.event.Frame;
import haltere.core.event.SensorGeometry;
import haltere.ui.rendering.FramePictures;
import java.awt.image.BufferedImage;
import java.nio.ShortBuffer;
import java.util.Arrays;

/**
 * The camera's frames below the events, each shown from the start of its exposure to that of the
 * next. After a jump, the previous frame must be {@link #give given}.
 *
 * <p>Thread rule: {@link #paintUnder} on the thread that paints, all else on any thread.
 */
public final class FrameLayer {
  /** Rank from which the colour of an event hides the frame, as {@code ColourRanks} gives it. */
  private static final int FULL_RANK = 60;

  private static final int NONE = -1;

  private volatile Frame latest;
  private boolean isRequested;
  private Frame shown;
  private int shownShift;
  private int[] colours = {};

  /**
   * Used bits of frames, up to 16, as 10 and 12 bits are stored in 16 too. It only grows, so that
   * frames of a recording are equally bright.
   */
  private volatile int usedBits;

  /** The next frame of the stream. */
  synchronized void take(Frame frame) {
    usedBits |= usedBits(frame);
    latest = frame;
    isRequested = false;
  }

  /** Bits that are set in any value of a frame of 16 bits, 0 for other frames. */
  public static int usedBits(Frame frame) {
    int bits = 0;
    if (frame.depth() == Frame.Depth.UNSIGNED_16) {
      ShortBuffer values = frame.rows().asShortBuffer();
      while (values.hasRemaining()) {
        bits |= values.get() & 0xFFFF;
      }
    }
    return bits;
  }

  /** Shows all frames as bright as those that use these bits. */
  synchronized void useBits(int bits) {
    usedBits |= bits;
  }

  synchronized void jump() {
    latest = null;
    isRequested = true;
  }

  /** Whether no frame has come since the last jump, so that the previous one is needed. */
  public synchronized boolean isFrameRequested() {
    return isRequested;
  }

  /** Sets the frame before the position of the last jump; ignored once another came. */
  synchronized boolean give(Frame frame) {
    boolean wanted = isRequested;
    if (wanted) {
      take(frame);
    }
    return wanted;
  }

  /**
   * Blends the frame below painted events: colours with ranks, row by row from the top, are changed
   * where the background is visible, by the opacity, 0 to 1.
   */
  void paintUnder(int[] ranked, SensorGeometry geometry, int background, double opacity) {
    Frame now = latest;
    if (now == null || opacity == 0) {
      return;
    }
    int shift = shift(now);
    if (now != shown || shift != shownShift) {
      shown = now;
      shownShift = shift;
      colours = colours(now, geometry, shift);
    }
    int scale = (int) Math.round(opacity * 256);
    for (int i = 0; i < geometry.pixels(); i++) {
      if (colours[i] != NONE) {
        ranked[i] = mixed(ranked[i], colours[i], background, scale);
      }
    }
  }

  /**
   * An event's colour is a mixture of its own and the background's; the frame replaces the latter.
   */
  private static int mixed(int ranked, int frame, int background, int scale) {
    int rest = Math.max(0, FULL_RANK - (ranked >>> 24)) * scale;
    if (rest == 0) {
      return ranked;
    }
    int red = channel(ranked, frame, background, rest, 16);
    int green = channel(ranked, frame, background, rest, 8);
    int blue = channel(ranked, frame, background, rest, 0);
    return ranked & 0xFF000000 | red << 16 | green << 8 | blue;
  }

  private static int channel(int event, int frame, int background, int rest, int shift) {
    int difference = (frame >> shift & 0xFF) - (background >> shift & 0xFF);
    int value = (event >> shift & 0xFF) + difference * rest / (FULL_RANK * 256);
    return Math.max(0, Math.min(255, value));
  }

  /** Bits of a value below the eight that are shown. */
  private int shift(Frame frame) {
    if (frame.depth() != Frame.Depth.UNSIGNED_16) {
      return frame.depth().bytes() > 1 ? 8 : 0;
    }
    return usedBits < 1 << 10 ? 2 : usedBits < 1 << 12 ? 4 : 8;
  }

  /** The colour of each pixel of the sensor, row by row from the top. */
  private int[] colours(Frame frame, SensorGeometry geometry, int shift) {
    int[] painted = colours.length == geometry.pixels() ? colours : new int[geometry.pixels()];
    Arrays.fill(painted, NONE);
    BufferedImage picture = FramePictures.draw(frame);
    for (int row = 0; row < frame.height(); row++) {
      int y = frame.bottom() + frame.height() - 1 - row;
      for (int column = 0; column < frame.width(); column++) {
        int x = frame.left() + column;
        if (geometry.contains(x, y)) {
          int at = (geometry.height() - 1 - y) * geometry.width() + x;
          painted[at] = colour(picture, column, row, frame.channels(), shift);
        }
      }
    }
    return painted;
  }

  private static int colour(BufferedImage picture, int x, int y, int channels, int shift) {
    if (channels >= 3) {
      return picture.getRGB(x, y) & 0xFFFFFF;
    }
    // stored value: the conversion of a grey image would brighten it
    int grey = picture.getRaster().getSample(x, y, 0) >> shift;
    return grey << 16 | grey << 8 | grey;
  }
}
