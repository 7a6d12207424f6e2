package haltere.filters.cluster;

import haltere.core.event.SensorGeometry;
import java.util.Arrays;

/**
 * Which clusters may take an event at a place: a grid of cells over the sensor, each of which knows
 * the clusters whose regions reach into it, whatever their number.
 */
final class ClusterGrid {
  /** Cells along the longer side, about. */
  private static final int CELLS = 96;

  /** Clusters that a cell names; where there are more, all have to be looked at. */
  private static final int NAMED = 4;

  /** What {@link #count} says of a cell that more clusters reach than it can name. */
  static final int ALL = NAMED + 1;

  /** How far a cluster may move beside its velocity before its cells are looked for again. */
  private static final double SLACK_PX = 2;

  private final int shift;
  private final int columns;
  private final int rows;
  private final byte[] counts;
  private final short[] names;

  ClusterGrid(SensorGeometry geometry) {
    int bits = 2;
    while (geometry.longerSide() >> bits > CELLS) {
      bits++;
    }
    shift = bits;
    columns = (geometry.width() - 1 >> shift) + 1;
    rows = (geometry.height() - 1 >> shift) + 1;
    counts = new byte[columns * rows];
    names = new short[columns * rows * NAMED];
  }

  int cellOf(int x, int y) {
    return (y >> shift) * columns + (x >> shift);
  }

  /** How many clusters reach a cell, or {@link #ALL} for more than it names. */
  int count(int cell) {
    return counts[cell];
  }

  /** Place in the list of one of the clusters of a cell. */
  int name(int cell, int number) {
    return names[cell * NAMED + number];
  }

  /**
   * Learns anew where all clusters are. Each may move by two pixels, and by its velocity, until the
   * next time.
   */
  void index(Cluster[] clusters, int count, double seconds) {
    Arrays.fill(counts, (byte) 0);
    for (int i = 0; i < count; i++) {
      Cluster cluster = clusters[i];
      double speed = Math.abs(cluster.vx) + Math.abs(cluster.vy);
      cluster.indexX = cluster.x;
      cluster.indexY = cluster.y;
      cluster.indexSlack = SLACK_PX + speed * seconds;
      // A pixel more, for a velocity that changes on the way.
      double margin = SLACK_PX + 2 * speed * seconds + 1;
      int left = cell(cluster.x - cluster.extentX - margin, columns);
      int right = cell(cluster.x + cluster.extentX + margin, columns);
      int bottom = cell(cluster.y - cluster.extentY - margin, rows);
      int top = cell(cluster.y + cluster.extentY + margin, rows);
      for (int row = bottom; row <= top; row++) {
        for (int column = left; column <= right; column++) {
          add(row * columns + column, i);
        }
      }
    }
  }

  private void add(int cell, int index) {
    int count = counts[cell];
    if (count < NAMED) {
      names[cell * NAMED + count] = (short) index;
      counts[cell] = (byte) (count + 1);
    } else {
      counts[cell] = ALL;
    }
  }

  private int cell(double place, int cells) {
    return (int) Math.max(0, Math.min(cells - 1, Math.floor(place) / (1 << shift)));
  }
}
