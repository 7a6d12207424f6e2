package haltere.filters.cluster;

import haltere.core.event.SensorGeometry;
import haltere.filters.cluster.ClusterVelocitySettings.Start;
import java.util.Arrays;

/**
 * Where events that belong to no cluster gather: cells, each with the number of its recent events
 * and their sums. A cluster is born where a cell and its eight neighbours together have more of
 * them than noise makes, and not all at one pixel. What an event costs does not depend on how many
 * clusters or how many places there are.
 *
 * <p>Noise is what there is everywhere: the mean number over all cells, averaged over half a
 * second, but for the cells that have far more than the others. More than noise is five standard
 * deviations of a Poisson count above it.
 */
final class BirthPlaces {
  private static final double SIGMAS = 5;

  /** How many times as many events as noise makes. */
  private static final double CONTRAST = 1.6;

  private static final double NOISE_TIME_US = 500_000;

  /** Radial variance below which the events of a place are one flickering pixel, pixels squared. */
  private static final double LEAST_VARIANCE = 0.3;

  /** A cell with more than this many times the mean, plus one, has more than noise. */
  private static final double CROWD = 3;

  /** Clusters cannot cover more than all but this. */
  private static final double LEAST_FREE = 0.2;

  private static final int REMEMBERED = 256;

  private final int shift;
  private final int columns;
  private final int rows;
  private final double area;

  // Of each cell: recent events, sums of their columns, rows and squared distances from the
  // sensor's origin, upkeep of the last one, time of the first one.
  private final float[] count;
  private final double[] sumX;
  private final double[] sumY;
  private final double[] sumSquares;
  private final long[] atUpkeep;
  private final long[] firstUs;

  private final double[] decay = new double[REMEMBERED];
  private double leastEvents;
  private double noiseGain;
  private double recentUpkeeps;
  private double upkeepUs;

  private long upkeep;
  private long strays;
  private long sinceUpkeep;
  private long lastStrayAt;
  private double straysPerUpkeep;
  private double needed;
  private double crowd;

  // The birth that was found.
  private double bornX;
  private double bornY;
  private double bornEvents;
  private long bornFirstUs;
  private int bornColumn;
  private int bornRow;

  /** The events themselves, where newborn clusters begin with their velocity; else null. */
  private FirstEvents firstEvents;

  BirthPlaces(SensorGeometry geometry, double radius) {
    int bits = 2;
    while (1.5 * (1 << bits) < radius) {
      bits++;
    }
    shift = bits;
    columns = (geometry.width() - 1 >> shift) + 1;
    rows = (geometry.height() - 1 >> shift) + 1;
    area = (double) geometry.width() * geometry.height();
    int cells = columns * rows;
    count = new float[cells];
    sumX = new double[cells];
    sumY = new double[cells];
    sumSquares = new double[cells];
    atUpkeep = new long[cells];
    firstUs = new long[cells];
  }

  void apply(ClusterTrackerSettings settings) {
    upkeepUs = settings.output().upkeepUs();
    leastEvents = settings.life().birthEvents();
    recentUpkeeps = settings.life().recentUs() / upkeepUs;
    noiseGain = 1 - StrictMath.exp(-upkeepUs / NOISE_TIME_US);
    for (int i = 0; i < REMEMBERED; i++) {
      decay[i] = StrictMath.exp(-i / recentUpkeeps);
    }
    crowd = CROWD;
    firstEvents = settings.motion().velocity().start() == Start.EVENTS ? new FirstEvents() : null;
    setNeeded();
  }

  void reset() {
    if (firstEvents != null) {
      firstEvents.clear();
    }
    Arrays.fill(count, 0);
    Arrays.fill(atUpkeep, 0);
    straysPerUpkeep = 0;
    strays = 0;
    sinceUpkeep = 0;
    upkeep = 0;
    lastStrayAt = 0;
    crowd = CROWD;
    setNeeded();
  }

  /**
   * Time goes on by one upkeep.
   *
   * @param thinEvents events since the last one that clusters took and that may be noise
   * @param densePixels pixels whose events clusters took that are none
   */
  void upkeep(double thinEvents, double densePixels) {
    upkeep++;
    double free = Math.max(LEAST_FREE, 1 - densePixels / area);
    straysPerUpkeep +=
        Math.max(noiseGain, 1.0 / upkeep) * ((strays + thinEvents) / free - straysPerUpkeep);
    strays = 0;
    sinceUpkeep = 0;
    crowd = CROWD * (1 + straysPerUpkeep * recentUpkeeps / count.length);
    setNeeded();
  }

  /** Whether nothing is left that could matter at an upkeep later on. */
  boolean areForgotten() {
    return upkeep - lastStrayAt >= REMEMBERED && straysPerUpkeep < 1e-3;
  }

  private void setNeeded() {
    // An edge of the sensor has fewer neighbours, which errs on the side of births.
    double noise = noiseOf(9.0 * (1 << 2 * shift));
    needed = Math.max(leastEvents, Math.max(CONTRAST * noise, noise + SIGMAS * Math.sqrt(noise)));
  }

  /** Whether what there is has been seen for long enough to tell noise from what moves. */
  boolean knowNoise() {
    return upkeep > recentUpkeeps;
  }

  /** Recent events that noise makes within an area of some pixels. */
  double noiseOf(double pixels) {
    return straysPerUpkeep * recentUpkeeps * Math.min(1, pixels / area);
  }

  /**
   * Takes an event that is in no cluster.
   *
   * @return whether a cluster is to be born here
   */
  boolean add(int x, int y, long timeUs) {
    lastStrayAt = upkeep;
    if (firstEvents != null) {
      firstEvents.add(x, y, timeUs);
    }
    int column = x >> shift;
    int row = y >> shift;
    int cell = row * columns + column;
    double recent = recent(cell);
    if (recent < 0.5) {
      firstUs[cell] = timeUs;
    }
    double share = count[cell] > 0 ? recent / count[cell] : 0;
    sinceUpkeep++;
    if (recent < crowd) {
      strays++;
    }
    count[cell] = (float) (recent + 1);
    sumX[cell] = sumX[cell] * share + x;
    sumY[cell] = sumY[cell] * share + y;
    sumSquares[cell] = sumSquares[cell] * share + (x * x + y * y);
    atUpkeep[cell] = upkeep;
    // Nine cells with fewer than a ninth each would not be enough.
    return count[cell] * 4 >= needed && isBirth(column, row);
  }

  private double recent(int cell) {
    long ago = upkeep - atUpkeep[cell];
    return ago < REMEMBERED ? count[cell] * decay[(int) ago] : 0;
  }

  private boolean isBirth(int column, int row) {
    bornColumn = column;
    bornRow = row;
    int left = Math.max(0, column - 1);
    int right = Math.min(columns - 1, column + 1);
    int bottom = Math.max(0, row - 1);
    int top = Math.min(rows - 1, row + 1);
    double events = 0;
    for (int r = bottom; r <= top; r++) {
      for (int cell = r * columns + left; cell <= r * columns + right; cell++) {
        double recent = recent(cell);
        events += recent > 0.5 ? recent : 0;
      }
    }
    // What came since the last upkeep is not in the mean yet, at the beginning nothing is.
    double noise = CONTRAST * sinceUpkeep * Math.min(1, 9.0 * (1 << 2 * shift) / area);
    if (events < needed || events < noise) {
      return false;
    }
    return isSpread(events, left, right, bottom, top);
  }

  /** Whether recent events of some cells are not one flickering pixel's; where they are. */
  private boolean isSpread(double events, int left, int right, int bottom, int top) {
    double x = 0;
    double y = 0;
    double squares = 0;
    long first = Long.MAX_VALUE;
    for (int r = bottom; r <= top; r++) {
      for (int cell = r * columns + left; cell <= r * columns + right; cell++) {
        double recent = recent(cell);
        if (recent > 0.5) {
          double share = recent / count[cell];
          x += share * sumX[cell];
          y += share * sumY[cell];
          squares += share * sumSquares[cell];
          first = Math.min(first, firstUs[cell]);
        }
      }
    }
    bornX = x / events;
    bornY = y / events;
    bornEvents = events;
    bornFirstUs = first;
    return squares / events - bornX * bornX - bornY * bornY > LEAST_VARIANCE;
  }

  /** Forgets the events of the last birth, which are the cluster's now. */
  void clearBirth(int x, int y) {
    int column = x >> shift;
    int row = y >> shift;
    for (int r = Math.max(0, row - 1); r <= Math.min(rows - 1, row + 1); r++) {
      Arrays.fill(
          count,
          r * columns + Math.max(0, column - 1),
          r * columns + Math.min(columns - 1, column + 1) + 1,
          0);
    }
  }

  /** Gives the cluster of the last birth the velocity of its events, if it is to begin with it. */
  void setVelocity(Cluster born) {
    if (firstEvents != null) {
      firstEvents.setVelocity(
          born,
          bornColumn - 1 << shift,
          bornRow - 1 << shift,
          (bornColumn + 2 << shift) - 1,
          (bornRow + 2 << shift) - 1,
          bornFirstUs);
    }
  }

  double bornX() {
    return bornX;
  }

  double bornY() {
    return bornY;
  }

  double bornEvents() {
    return bornEvents;
  }

  long bornFirstUs() {
    return bornFirstUs;
  }
}
