package haltere.filters.track.road;

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
 * <p>Thread rule: not safe for use by two threads at a time.
 */
public final class RoadEvents {
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

  /**
   * None so far.
   *
   * @param road what each pixel sees of it
   * @param sensor whose events they are
   */
  public RoadEvents(RoadMapping road, SensorGeometry sensor) {
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

  /** Forgets all of them. */
  public void clear() {
    from = added;
    to = added;
  }

  /**
   * Adds the events of a packet that see the road, for steps to come.
   *
   * @param packet only read
   */
  public void add(EventPacket packet) {
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

  /**
   * Goes on to the events since the last step and before a time.
   *
   * @param timeUs the time of the step
   */
  public void step(long timeUs) {
    from = to;
    while (to < added && timesUs[(int) to & mask] < timeUs) {
      to++;
    }
  }

  /**
   * The first event of the step.
   *
   * @return its number among all events
   */
  public long from() {
    return from;
  }

  /**
   * Where the events of the step end.
   *
   * @return the number behind that of the last one
   */
  public long to() {
    return to;
  }

  /** Whether an event of the step may be looked back at, and is not too long ago. */
  boolean isRemembered(long event, long sinceUs) {
    return event >= 0 && event >= to - MOST_BACK && timeUs(event) >= sinceUs;
  }

  /**
   * Whether an event up to the step is still kept, and is not too long ago.
   *
   * @param event its number
   * @param sinceUs a time
   * @return true if it is not before that time
   */
  public boolean isKept(long event, long sinceUs) {
    return event >= 0 && event >= to - MOST_KEPT && timeUs(event) >= sinceUs;
  }

  /**
   * Whether there is anything that a step would take, or may look back at.
   *
   * @param timeUs the time of the step
   * @return true if so
   */
  public boolean isWaiting(long timeUs) {
    return to < added && timeUs(to) < timeUs
        || to > 0 && isRemembered(to - 1, timeUs - LONGEST_BACK_US);
  }

  /**
   * When an event was.
   *
   * @param event its number
   * @return microseconds
   */
  public long timeUs(long event) {
    return timesUs[(int) event & mask];
  }

  /**
   * Where an event was.
   *
   * @param event its number
   * @return column of the picture
   */
  public int column(long event) {
    return EventAddress.x(addresses[(int) event & mask]);
  }

  /**
   * Where an event was.
   *
   * @param event its number
   * @return row of the picture
   */
  public int row(long event) {
    return EventAddress.y(addresses[(int) event & mask]);
  }

  /**
   * Polarity of an event.
   *
   * @param event its number
   * @return true if it became brighter
   */
  public boolean isOn(long event) {
    return EventAddress.isOn(addresses[(int) event & mask]);
  }

  /** Whether an event belongs to a vehicle that is known. */
  boolean isTaken(long event) {
    return owners[(int) event & mask] != NOBODY;
  }

  /**
   * Whether an event belongs to another vehicle than a certain one.
   *
   * @param event its number
   * @param serial the number of that vehicle
   * @return false also if it belongs to none
   */
  public boolean isOfOther(long event, int serial) {
    int owner = owners[(int) event & mask];
    return owner != NOBODY && owner != serial;
  }

  /**
   * Says that an event belongs to a vehicle.
   *
   * @param event its number
   * @param serial the number of the vehicle, not 0
   */
  public void take(long event, int serial) {
    owners[(int) event & mask] = serial;
  }

  /**
   * Share of the rows strictly between two in which there were events of late, in a band from the
   * one row's columns to the other's.
   *
   * @param low the one row
   * @param high the other, above it
   * @param lowLateralM the middle of the band in the one row, metres to the right
   * @param highLateralM the same in the other
   * @param halfM half of the width of the band, metres
   * @return from 0 to 1; 1 if there is no row between them
   */
  public double filledShare(
      int low, int high, double lowLateralM, double highLateralM, double halfM) {
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

  /**
   * Where the road is that a pixel sees, across.
   *
   * @param column of the picture
   * @param row of the picture, which sees the road
   * @return metres to the right
   */
  public double lateralM(double column, int row) {
    return (column - road.vanishingX()) * metresPerColumn[row];
  }

  /**
   * Where the road is that a row sees, along.
   *
   * @param row of the picture
   * @return metres ahead, NaN if it does not see the road
   */
  public double distanceM(int row) {
    return distanceM[row];
  }

  /**
   * How much of the road a column is worth.
   *
   * @param row of the picture
   * @return metres across, NaN if it does not see the road
   */
  public double metresPerColumn(int row) {
    return metresPerColumn[row];
  }

  /**
   * How much of the road a row is worth.
   *
   * @param row of the picture
   * @return metres along, NaN if it does not see the road
   */
  public double metresPerRow(int row) {
    return metresPerRow[row];
  }

  /**
   * Rows of the sensor.
   *
   * @return as many as there are, with those that do not see the road
   */
  public int rows() {
    return distanceM.length;
  }

  /**
   * Columns of the sensor.
   *
   * @return as many as there are
   */
  public int columns() {
    return columns;
  }
}
