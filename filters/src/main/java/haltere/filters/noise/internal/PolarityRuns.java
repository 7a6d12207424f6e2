package haltere.filters.noise.internal;

import haltere.core.event.EventAddress;
import haltere.core.event.SensorGeometry;
import java.util.Arrays;

/**
 * Runs of events of one polarity on a pixel, as a passing edge makes them: the first one has the
 * time of the edge.
 */
public final class PolarityRuns {
  /** A run ends after this time, whatever comes. */
  private static final int LONGEST_RUN_US = 2500;

  /**
   * A pixel that is quiet for so long after an ON event is no longer passed: less than half of the
   * shortest beat of a wing, 1.25 ms at 400 Hz, for which it is quiet between two passages.
   */
  private static final int QUIET_US = 1000;

  /** Bits of pixels that do not tell of passages: one of 16 does, as many as a median needs. */
  private static final int LEFT_OUT = EventAddress.pack(3, 3, 0);

  private static final long NO_EVENT = Long.MIN_VALUE >> 1;

  private final int width;
  private final long[] lastOfPixel;

  /** First OFF event of the passage of a pixel. */
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
    openedUs = new long[geometry.pixels()];
    answeredUs = new long[geometry.pixels()];
    clear();
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
      passage(pixel, now, before);
    }
    return true;
  }

  private void passage(int pixel, long now, long before) {
    long nowUs = now >> 1;
    long beforeUs = before >> 1;
    boolean wasOn = (before & EventAddress.ON_BIT) != 0;
    if ((now & EventAddress.ON_BIT) != 0) {
      if (answeredUs[pixel] == NO_EVENT && !wasOn) {
        answeredUs[pixel] = nowUs + beforeUs - openedUs[pixel];
      }
    } else if (nowUs - beforeUs > QUIET_US) {
      resolvedUs = beforeUs - answeredUs[pixel];
      hasPassed = wasOn && Math.abs(resolvedUs) < QUIET_US;
      openedUs[pixel] = nowUs;
      answeredUs[pixel] = NO_EVENT;
    }
  }
}
