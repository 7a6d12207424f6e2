package haltere.ui.rendering;

import haltere.core.stream.StreamNotification;
import java.util.Arrays;
import java.util.Objects;

/**
 * Paints an {@link EventFrame} into an array of ARGB pixels: each pixel in the colour of its last
 * event, fading exponentially with the event's age.
 *
 * <p>The fading is read from a table by age, so a picture costs about a nanosecond a pixel.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class FramePainter {
  /** Ages beyond this many time constants are painted as background (a share of 0.2 %). */
  private static final double TIME_CONSTANTS = 6;

  /** Longest time constant, 20 s. An {@link EventFrame} does not remember for longer. */
  public static final long LONGEST_TIME_CONSTANT_US = 20_000_000;

  /** Shortest table; the age is cut to fit between this and twice as many entries. */
  private static final int ENTRIES = 1024;

  private ColourMap colours;
  private long timeConstantUs;

  /** At twice the cut age, plus 1 for ON. The last pair is the background. */
  private int[] table;

  private int ageShift;

  private int[] row = new int[0];

  /**
   * A painter.
   *
   * @param colours the map
   * @param timeConstantUs age at which an event has faded to 1/e, 1 us to {@link
   *     #LONGEST_TIME_CONSTANT_US}
   */
  public FramePainter(ColourMap colours, long timeConstantUs) {
    configure(colours, timeConstantUs);
  }

  /**
   * Changes what the next picture looks like.
   *
   * @param newColours the map
   * @param newTimeConstantUs age at which an event has faded to 1/e, 1 us to {@link
   *     #LONGEST_TIME_CONSTANT_US}
   */
  public void configure(ColourMap newColours, long newTimeConstantUs) {
    if (newTimeConstantUs < 1 || newTimeConstantUs > LONGEST_TIME_CONSTANT_US) {
      throw new IllegalArgumentException(
          "the time constant is " + newTimeConstantUs + " us, it must be 1 us to 20 s");
    }
    if (newTimeConstantUs == timeConstantUs && newColours.equals(colours)) {
      return;
    }
    colours = Objects.requireNonNull(newColours, "colours");
    timeConstantUs = newTimeConstantUs;
    double oldestUs = timeConstantUs * TIME_CONSTANTS;
    ageShift = 0;
    while (oldestUs / (1L << ageShift) >= 2 * ENTRIES) {
      ageShift++;
    }
    int entries = (int) (oldestUs / (1L << ageShift)) + 2;
    table = new int[2 * entries];
    for (int i = 0; i < entries - 1; i++) {
      double freshness = Math.exp(-((double) i * (1L << ageShift)) / timeConstantUs);
      table[2 * i] = colours.colour(false, freshness);
      table[2 * i + 1] = colours.colour(true, freshness);
    }
    table[2 * entries - 2] = colours.background();
    table[2 * entries - 1] = colours.background();
  }

  /**
   * The colours in use.
   *
   * @return a map
   */
  public ColourMap colours() {
    return colours;
  }

  /**
   * The time constant in use.
   *
   * @return microseconds
   */
  public long timeConstantUs() {
    return timeConstantUs;
  }

  /**
   * Paints.
   *
   * @param frame what to paint, at the age that its {@link EventFrame#nowUs()} says
   * @param argb receives one opaque pixel for each of the sensor's, row by row from the TOP
   */
  public void paint(EventFrame frame, int[] argb) {
    int width = frame.geometry().width();
    int height = frame.geometry().height();
    int[] lastEvents = frame.lastEvents();
    Objects.checkFromIndexSize(0, lastEvents.length, argb.length);
    if (frame.nowUs() == StreamNotification.NO_TIME_US) {
      Arrays.fill(argb, 0, lastEvents.length, colours.background());
      return;
    }
    if (row.length < width) {
      row = new int[width];
    }
    for (int y = 0; y < height; y++) {
      indices(lastEvents, y * width, width, frame.now(), ageShift, table.length - 2, row);
      colours(row, width, table, argb, (height - 1 - y) * width);
    }
  }

  /**
   * Places in the table for a row of pixels. By itself, the compiler makes vectors of this loop.
   */
  private static void indices(
      int[] lastEvents, int from, int width, int now, int shift, int oldest, int[] indices) {
    for (int x = 0; x < width; x++) {
      int entry = lastEvents[from + x];
      // both have the polarity in the lowest bit, which is cleared and set anew
      int age = now - (entry & ~1) >> shift & ~1;
      indices[x] = Math.max(0, Math.min(oldest, age)) | entry & 1;
    }
  }

  private static void colours(int[] indices, int width, int[] table, int[] argb, int to) {
    for (int x = 0; x < width; x++) {
      argb[to + x] = table[indices[x]];
    }
  }
}
