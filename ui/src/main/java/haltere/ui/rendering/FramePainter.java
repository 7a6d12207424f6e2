package haltere.ui.rendering;

import haltere.core.stream.StreamNotification;
import java.util.Arrays;
import java.util.Objects;

/**
 * Paints an {@link EventFrame} into ARGB pixels, by the polarity and the age of each pixel's last
 * event.
 *
 * <p>That is read from a table by age, so a picture costs about a nanosecond a pixel.
 */
public final class FramePainter {
  /** Ages beyond this many time constants are painted as background (a share of 0.2 %). */
  static final double TIME_CONSTANTS = 6;

  /** Longest time constant, 20 s. An {@link EventFrame} does not remember for longer. */
  public static final long MAX_TIME_CONSTANT_US = 20_000_000;

  /** Shortest table; the age is cut to fit between this and twice as many entries. */
  private static final int ENTRIES = 1024;

  private PictureStyle style;

  /** Ranked colours at twice the cut age, plus 1 for ON. The last pair is the background. */
  private int[] table;

  private int ageShift;

  private int[] row = new int[0];

  /** A painter; events fade to 1/e within 1 us to {@link #MAX_TIME_CONSTANT_US}. */
  public FramePainter(ColourMap colours, long timeConstantUs) {
    configure(PictureStyle.fading(colours, timeConstantUs));
  }

  /** Changes the style of the next picture, to one that needs only the last event of a pixel. */
  public void configure(PictureStyle newStyle) {
    if (newStyle.equals(style)) {
      return;
    }
    style = newStyle;
    double oldestUs = style.maxAgeUs();
    ageShift = 0;
    while (oldestUs / (1L << ageShift) >= 2 * ENTRIES) {
      ageShift++;
    }
    int entries = (int) (oldestUs / (1L << ageShift)) + 2;
    table = new int[2 * entries];
    for (int i = 0; i < entries - 1; i++) {
      double ageUs = (double) i * (1L << ageShift);
      table[2 * i] = style.colour(false, ageUs);
      table[2 * i + 1] = style.colour(true, ageUs);
    }
    table[2 * entries - 2] = style.background();
    table[2 * entries - 1] = style.background();
    ColourRanks.rank(table, style.background());
  }

  /** The colours in use. */
  public ColourMap colours() {
    return style.colours();
  }

  /**
   * Paints a frame at its {@link EventFrame#nowUs()}: an opaque pixel for each of the sensor's, row
   * by row from the TOP.
   */
  public void paint(EventFrame frame, int[] argb) {
    paintRanked(frame, argb);
    PictureScaler.makeOpaque(argb, argb);
  }

  /** Paints colours that carry their rank. */
  void paintRanked(EventFrame frame, int[] ranked) {
    int width = frame.geometry().width();
    int height = frame.geometry().height();
    int[] lastEvents = frame.lastEvents();
    Objects.checkFromIndexSize(0, lastEvents.length, ranked.length);
    if (frame.nowUs() == StreamNotification.NO_TIME_US) {
      Arrays.fill(ranked, 0, lastEvents.length, table[table.length - 1]);
      return;
    }
    if (row.length < width) {
      row = new int[width];
    }
    for (int y = 0; y < height; y++) {
      indices(lastEvents, y * width, width, frame.now(), ageShift, table.length - 2, row);
      int to = (height - 1 - y) * width;
      for (int x = 0; x < width; x++) {
        ranked[to + x] = table[row[x]];
      }
    }
  }

  /**
   * Indices in the table for a row of pixels. Separate, so that the compiler vectorises this loop.
   */
  private static void indices(
      int[] lastEvents, int from, int width, int now, int shift, int oldest, int[] indices) {
    for (int x = 0; x < width; x++) {
      int entry = lastEvents[from + x];
      // both have the polarity in the lowest bit
      int age = now - (entry & ~1) >> shift & ~1;
      indices[x] = Math.max(0, Math.min(oldest, age)) | entry & 1;
    }
  }
}
