package haltere.filters.track.kalman;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.filters.track.RoadMapping;
import java.util.Arrays;

/**
 * The events of the last second on the road, each with the place of the road that its pixel sees.
 * Events come in by packets and are counted from 0 on; a step takes those before its time, whatever
 * packets they came in. Allocates only when a packet is larger than any before.
 *
 * <p>Thread rule: that of its owner.
 */
final class RoadEvents {
  /** This many events before a step are looked back at, at most. */
  private static final int MOST_BACK = 1 << 14;

  /** This many are kept for those who want to know where a vehicle has come from. */
  private static final int MOST_KEPT = 1 << 16;

  private static final int NOBODY = 0;

  private static final long LONGEST_BACK_US = 1_000_000;
  private static final long FILLED_US = 100_000;

  private final RoadMapping road;
  private final double[] distanceM;
  private final double[] metresPerColumn;
  private final double[] metresPerRow;
  private long[] timesUs = new long[2 * MOST_KEPT];
  private int[] addresses = new int[2 * MOST_KEPT];
  private int[] owners = new int[2 * MOST_KEPT];
  private int mask = 2 * MOST_KEPT - 1;
  private final int columns;
  private final boolean[] heard;
  private long added;
  private long from;
  private long to;

  RoadEvents(RoadMapping road, SensorGeometry sensor) {
    this.road = road;
    int rows = sensor.height();
    columns = sensor.width();
    distanceM = new double[rows];
    metresPerColumn = new double[rows];
    metresPerRow = new double[rows];
    heard = new boolean[rows];
    for (int row = 0; row < rows; row++) {
      boolean seen = road.onRoad(row);
      distanceM[row] = seen ? road.distanceM(row) : Double.NaN;
      metresPerColumn[row] = seen ? road.lateralPerX(row) : Double.NaN;
      metresPerRow[row] = seen ? road.distancePerY(row) : Double.NaN;
    }
  }

  void clear() {
    from = added;
    to = added;
  }

  /** Adds the events of a packet that see the road, for steps to come. */
  void add(EventPacket packet) {
    int needed = Integer.highestOneBit(Math.max(1, packet.size()) + MOST_KEPT) * 2;
    if (needed > mask + 1) {
      grow(needed);
    }
    long[] times = packet.timesUs();
    int[] packed = packet.addresses();
    for (int i = 0; i < packet.size(); i++) {
      if (distanceM[EventAddress.y(packed[i])] > 0) {
        int at = (int) added++ & mask;
        timesUs[at] = times[i];
        addresses[at] = packed[i];
        owners[at] = NOBODY;
      }
    }
  }

  private void grow(int size) {
    long[] oldTimes = timesUs;
    int[] oldAddresses = addresses;
    int[] oldOwners = owners;
    int oldMask = mask;
    timesUs = new long[size];
    addresses = new int[size];
    owners = new int[size];
    mask = size - 1;
    for (long i = Math.max(0, added - oldMask - 1); i < added; i++) {
      int at = (int) i & mask;
      int before = (int) i & oldMask;
      timesUs[at] = oldTimes[before];
      addresses[at] = oldAddresses[before];
      owners[at] = oldOwners[before];
    }
  }

  /** Goes on to the events since the last step and before a time. */
  void step(long timeUs) {
    from = to;
    while (to < added && timesUs[(int) to & mask] < timeUs) {
      to++;
    }
  }

  /** The first event of the step. */
  long from() {
    return from;
  }

  /** Behind the last event of the step. */
  long to() {
    return to;
  }

  /** Whether an event of the step may be looked back at, and is not too long ago. */
  boolean isRemembered(long event, long sinceUs) {
    return event >= 0 && event >= to - MOST_BACK && timeUs(event) >= sinceUs;
  }

  /** Whether an event of the step is kept, and is not too long ago. */
  boolean isKept(long event, long sinceUs) {
    return event >= 0 && event >= to - MOST_KEPT && timeUs(event) >= sinceUs;
  }

  /** Whether there is anything that a step at a time would take, or may look back at. */
  boolean isWaiting(long timeUs) {
    return to < added && timeUs(to) < timeUs
        || to > 0 && isRemembered(to - 1, timeUs - LONGEST_BACK_US);
  }

  long timeUs(long event) {
    return timesUs[(int) event & mask];
  }

  int column(long event) {
    return EventAddress.x(addresses[(int) event & mask]);
  }

  int row(long event) {
    return EventAddress.y(addresses[(int) event & mask]);
  }

  boolean isOn(long event) {
    return EventAddress.isOn(addresses[(int) event & mask]);
  }

  /** Whether it belongs to a vehicle that is known. */
  boolean isTaken(long event) {
    return owners[(int) event & mask] != NOBODY;
  }

  /** Whether it belongs to another vehicle than that of a number. */
  boolean isOfOther(long event, int serial) {
    int owner = owners[(int) event & mask];
    return owner != NOBODY && owner != serial;
  }

  /** Says that it belongs to the vehicle of a number, which is not 0. */
  void take(long event, int serial) {
    owners[(int) event & mask] = serial;
  }

  /**
   * Share of the rows strictly between two in which there were events of late, in a band from the
   * one row's columns to the other's.
   */
  double filledShare(int low, int high, double lowLateralM, double highLateralM, double halfM) {
    int rows = high - low - 1;
    if (rows <= 0) {
      return 1;
    }
    Arrays.fill(heard, 0, rows, false);
    int filled = 0;
    long sinceUs = to > 0 ? timeUs(to - 1) - FILLED_US : 0;
    for (long i = to - 1; isRemembered(i, sinceUs); i--) {
      int row = row(i);
      if (row > low && row < high && !heard[row - low - 1]) {
        double share = (double) (row - low) / (high - low);
        double middleM = lowLateralM + share * (highLateralM - lowLateralM);
        if (Math.abs(lateralM(column(i), row) - middleM) < halfM) {
          heard[row - low - 1] = true;
          filled++;
        }
      }
    }
    return (double) filled / rows;
  }

  /** Metres to the right of the road that a pixel sees. */
  double lateralM(double column, int row) {
    return (column - road.vanishingX()) * metresPerColumn[row];
  }

  /** Metres ahead of the road that a row sees. */
  double distanceM(int row) {
    return distanceM[row];
  }

  double metresPerColumn(int row) {
    return metresPerColumn[row];
  }

  double metresPerRow(int row) {
    return metresPerRow[row];
  }

  int rows() {
    return distanceM.length;
  }

  int columns() {
    return columns;
  }
}
