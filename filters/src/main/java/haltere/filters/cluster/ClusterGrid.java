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

  /** What a cell says if more clusters reach it than it can name. */
  static final int ALL = -1;

  /** How far a cluster may move beside its velocity before its cells are looked for again. */
  private static final double SLACK_PX = 2;

  /** The same for a velocity that changes on the way. */
  private static final double TURN_PX = 1;

  private final int shift;
  private final int columns;
  private final int rows;

  /**
   * One more than the place in the list of each cluster of a cell, a byte each, the first lowest:
   * there are never as many as 255 clusters, see {@link ClusterOutputSettings#mostClusters}.
   */
  private final int[] cells;

  ClusterGrid(SensorGeometry geometry) {
    int bits = 2;
    while (geometry.longerSide() >> bits > CELLS) {
      bits++;
    }
    shift = bits;
    columns = (geometry.width() - 1 >> shift) + 1;
    rows = (geometry.height() - 1 >> shift) + 1;
    cells = new int[columns * rows];
  }

  /** Which clusters may take an event: 0 for none, {@link #ALL}, or for {@link #name}. */
  int at(int x, int y) {
    return cells[(y >> shift) * columns + (x >> shift)];
  }

  /** How many clusters a cell names, if it is not {@link #ALL}. */
  static int count(int cell) {
    return Integer.SIZE + 7 - Integer.numberOfLeadingZeros(cell) >> 3;
  }

  /** Place in the list of one of the clusters that a cell names. */
  static int name(int cell, int number) {
    return (cell >> 8 * number & 0xff) - 1;
  }

  /**
   * Learns anew where all clusters are. Each may move by two pixels, and by its velocity, until the
   * next time.
   */
  void index(Clusters clusters, double seconds) {
    clusters.changed = false;
    Arrays.fill(cells, 0);
    for (int i = 0; i < clusters.count; i++) {
      Cluster cluster = clusters.all[i];
      double speed = Math.abs(cluster.vx) + Math.abs(cluster.vy);
      cluster.indexX = cluster.x;
      cluster.indexY = cluster.y;
      cluster.indexSlack = SLACK_PX + speed * seconds;
      double margin = cluster.indexSlack + speed * seconds + TURN_PX;
      cluster.indexReachX = cluster.extentX + margin;
      cluster.indexReachY = cluster.extentY + margin;
      int left = cell(cluster.x - cluster.indexReachX, columns);
      int right = cell(cluster.x + cluster.indexReachX, columns);
      int bottom = cell(cluster.y - cluster.indexReachY, rows);
      int top = cell(cluster.y + cluster.indexReachY, rows);
      for (int row = bottom; row <= top; row++) {
        for (int column = left; column <= right; column++) {
          cells[row * columns + column] = with(cells[row * columns + column], i);
        }
      }
    }
  }

  /** The same, if there are other clusters or some have gone too far or grown too large for it. */
  void refresh(Clusters clusters, double seconds) {
    if (clusters.changed || !holds(clusters, seconds)) {
      index(clusters, seconds);
    }
  }

  /** Whether each may go on until it has left what is free for it in the cells that it has. */
  private boolean holds(Clusters clusters, double seconds) {
    for (int i = 0; i < clusters.count; i++) {
      Cluster cluster = clusters.all[i];
      double way = (Math.abs(cluster.vx) + Math.abs(cluster.vy)) * seconds;
      double free =
          Math.min(cluster.indexReachX - cluster.extentX, cluster.indexReachY - cluster.extentY);
      cluster.indexSlack = free - way - TURN_PX;
      double gone = Math.abs(cluster.x - cluster.indexX) + Math.abs(cluster.y - cluster.indexY);
      // Not so if a place is not a number.
      if (!(gone + way <= cluster.indexSlack)) {
        return false;
      }
    }
    return true;
  }

  private static int with(int cell, int index) {
    int count = count(cell);
    return count < NAMED ? cell | index + 1 << 8 * count : ALL;
  }

  private int cell(double place, int cells) {
    return (int) Math.max(0, Math.min(cells - 1, Math.floor(place) / (1 << shift)));
  }
}
