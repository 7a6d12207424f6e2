package haltere.ui.viewer.picture;

import haltere.core.event.Frame;
import haltere.core.event.SensorGeometry;
import haltere.ui.rendering.FramePictures;
import java.awt.image.BufferedImage;
import java.nio.ShortBuffer;
import java.util.Arrays;

/**
 * The camera's frames below the events: each stands from the start of its exposure to the next one.
 * After a jump somebody has to {@link #give} the frame that was there before.
 *
 * <p>Thread rule: {@link #paintUnder} on the thread that paints, all else on any thread.
 */
public final class FrameLayer {
  /** Rank from which the colour of an event hides the frame, as {@code Ranks} gives it. */
  private static final int FULL_RANK = 60;

  private static final int NONE = -1;

  private volatile Frame latest;
  private boolean sought;
  private Frame shown;
  private int shownShift;
  private int[] colours = {};

  /**
   * Bits of 16 that frames use, as 10 and 12 bits are stored in 16 too. None is forgotten, so that
   * frames of a recording are equally bright.
   */
  private volatile int usedBits;

  /** The next frame of the stream. */
  synchronized void take(Frame frame) {
    usedBits |= usedBits(frame);
    latest = frame;
    sought = false;
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

  /** The stream goes on elsewhere. */
  synchronized void jump() {
    latest = null;
    sought = true;
  }

  /** Whether no frame has come since the last jump, so that the one before is wanted. */
  public synchronized boolean isSought() {
    return sought;
  }

  /** The frame that was there before the place of the last jump; of no use once another came. */
  synchronized boolean give(Frame frame) {
    boolean wanted = sought;
    if (wanted) {
      take(frame);
    }
    return wanted;
  }

  /**
   * Puts the frame below events that have been painted: colours with their ranks, row by row from
   * the top, are changed where the background stands for no event; of the frame so much is seen as
   * the opacity, 0 to 1.
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
    // the stored value: a grey picture's own conversion would brighten it
    int grey = picture.getRaster().getSample(x, y, 0) >> shift;
    return grey << 16 | grey << 8 | grey;
  }
}
