package haltere.filters.noise.internal;

import haltere.core.event.EventAddress;
import haltere.core.event.SensorGeometry;
import java.util.Arrays;

/**
 * Runs of events of one polarity on a pixel, as caused by a passing edge: the first one has the
 * time of the edge.
 */
public final class PolarityRuns {
  /** Longest run of one polarity at a pixel. */
  public static final int MAX_RUN_US = 2500;

  /**
   * Silence after an ON event that ends a passage: less than half of the shortest wing beat, 1.25
   * ms at 400 Hz, which is the silence between two passages.
   */
  private static final int QUIET_US = 1000;

  /** Passages are observed at every fourth pixel of every fourth row, enough for a median. */
  private static final int LEFT_OUT = EventAddress.pack(3, 3, 0);

  private static final int LEFT_OUT_BITS = 2;

  private static final long NO_EVENT = Long.MIN_VALUE >> 1;

  private final int width;
  private final long[] lastOfPixel;
  private final int passageColumns;

  /** First OFF event of the passage of an observed pixel. */
  private final long[] openedUs;

  /** Its last ON event if its run of ON events were as long as its first run of OFF events. */
  private final long[] answeredUs;

  private boolean hasPassed;
  private long resolvedUs;

  /**
   * A state without events.
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

  /** Removes all events. */
  public void clear() {
    Arrays.fill(lastOfPixel, NO_EVENT);
    Arrays.fill(openedUs, NO_EVENT);
    Arrays.fill(answeredUs, NO_EVENT);
    hasPassed = false;
  }

  /**
   * {@return whether the last event begins a passage, so that {@link #resolvedUs} is of the
   * previous one}
   */
  public boolean hasPassed() {
    return hasPassed;
  }

  /**
   * Resolved structure of the last passage: time from its first to its last ON event minus the
   * duration of its first run of OFF events. About 0 for a uniform shadow. After a vein the first
   * ON event is earlier than the trailing edge by this time.
   *
   * @return microseconds
   */
  public long resolvedUs() {
    return resolvedUs;
  }

  /**
   * Processes an event. Times are in the upper bits and the polarity in the last one, so that the
   * difference to the previous event, rotated by a bit, is half of it for equal polarities, and
   * larger than any time otherwise.
   *
   * @param timeUs time, microseconds
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
    if (since + Long.MIN_VALUE < MAX_RUN_US + Long.MIN_VALUE) {
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
