package haltere.filters.noise.internal;

import haltere.core.event.EventAddress;
import haltere.core.event.SensorGeometry;
import java.util.Arrays;

/**
 * Runs of events of one polarity on a pixel, as a passing edge makes them: the first one has the
 * time of the edge.
 */
public final class PolarityRuns {
  /** Longest run of one polarity at a pixel. */
  public static final int LONGEST_RUN_US = 2500;

  /**
   * A pixel that is quiet for so long after an ON event is no longer passed: less than half of the
   * shortest beat of a wing, 1.25 ms at 400 Hz, for which it is quiet between two passages.
   */
  private static final int QUIET_US = 1000;

  /** Passages are seen at every fourth pixel of every fourth row, enough for a median. */
  private static final int LEFT_OUT = EventAddress.pack(3, 3, 0);

  private static final int LEFT_OUT_BITS = 2;

  private static final long NO_EVENT = Long.MIN_VALUE >> 1;

  private final int width;
  private final long[] lastOfPixel;
  private final int passageColumns;

  /** First OFF event of the passage of a pixel that is not left out. */
  private final long[] openedUs;

  /** Its last ON event, were its run of ON events as long as its first run of OFF events. */
  private final long[] answeredUs;

  private boolean hasPassed;
  private long resolvedUs;

  /**
   * No event has come.
   *
   * @param geometry the sensor
   */
  public PolarityRuns(SensorGeometry geometry) {
    width = geometry.width();
    lastOfPixel = new long[geometry.pixels()];
    passageColumns = passagesAlong(width);
    openedUs = new long[passageColumns * passagesAlong(geometry.height())];
    answeredUs = new long[openedUs.length];
    clear();
  }

  private static int passagesAlong(int pixels) {
    return (pixels - 1 >> LEFT_OUT_BITS) + 1;
  }

  /** Forgets all events. */
  public void clear() {
    Arrays.fill(lastOfPixel, NO_EVENT);
    Arrays.fill(openedUs, NO_EVENT);
    Arrays.fill(answeredUs, NO_EVENT);
    hasPassed = false;
  }

  /**
   * {@return whether the event last taken begins a passage and {@link #resolvedUs} tells of the one
   * before}
   */
  public boolean hasPassed() {
    return hasPassed;
  }

  /**
   * What the last passage showed between its edges: time from its first to its last ON event less
   * the duration of its first run of OFF events. About 0 for a uniform shadow. A vein that leaves
   * makes the first ON event earlier than the trailing edge by this time.
   *
   * @return microseconds
   */
  public long resolvedUs() {
    return resolvedUs;
  }

  /**
   * Takes an event. Times stand in the upper bits and the polarity in the last one, so that the
   * difference to the event before, turned by a bit, is half of it where the polarities are alike,
   * and beyond any time where they are not.
   *
   * @param timeUs when, microseconds
   * @param address packed, on the sensor
   * @return whether it is the first of a run
   */
  public boolean begins(long timeUs, int address) {
    int pixel = EventAddress.y(address) * width + EventAddress.x(address);
    long now = timeUs << 1 | address & EventAddress.ON_BIT;
    long before = lastOfPixel[pixel];
    long since = Long.rotateRight(now - before, 1);
    lastOfPixel[pixel] = now;
    hasPassed = false;
    if (since + Long.MIN_VALUE < LONGEST_RUN_US + Long.MIN_VALUE) {
      return false;
    }
    if ((address & LEFT_OUT) == 0) {
      int row = EventAddress.y(address) >> LEFT_OUT_BITS;
      int column = EventAddress.x(address) >> LEFT_OUT_BITS;
      passage(row * passageColumns + column, now, before);
    }
    return true;
  }

  private void passage(int at, long now, long before) {
    long nowUs = now >> 1;
    long beforeUs = before >> 1;
    boolean wasOn = (before & EventAddress.ON_BIT) != 0;
    if ((now & EventAddress.ON_BIT) != 0) {
      if (answeredUs[at] == NO_EVENT && !wasOn) {
        answeredUs[at] = nowUs + beforeUs - openedUs[at];
      }
    } else if (nowUs - beforeUs > QUIET_US) {
      resolvedUs = beforeUs - answeredUs[at];
      hasPassed = wasOn && Math.abs(resolvedUs) < QUIET_US;
      openedUs[at] = nowUs;
      answeredUs[at] = NO_EVENT;
    }
  }
}
