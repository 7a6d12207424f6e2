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

  private static final long NO_EVENT = Long.MIN_VALUE >> 1;

  private final int width;
  private final long[] lastOfPixel;

  /**
   * No event has come.
   *
   * @param geometry the sensor
   */
  public PolarityRuns(SensorGeometry geometry) {
    width = geometry.width();
    lastOfPixel = new long[geometry.pixels()];
    clear();
  }

  /** Forgets all events. */
  public void clear() {
    Arrays.fill(lastOfPixel, NO_EVENT);
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
    long since = Long.rotateRight(now - lastOfPixel[pixel], 1);
    lastOfPixel[pixel] = now;
    return since + Long.MIN_VALUE >= LONGEST_RUN_US + Long.MIN_VALUE;
  }
}
