package haltere.filters.cluster;

import haltere.core.event.SensorGeometry;
import java.util.Arrays;

/**
 * Index of the clusters by position: each cell of a grid over the sensor lists the clusters whose
 * capture regions reach it. Clusters may move by {@link #SLACK_PX} before they are indexed again.
 */
final class ClusterGrid {
  /** Value of a cell in reach of more clusters than it can list. */
  static final long ALL = -1;

  /** Motion of a cluster that the index allows for, along each axis, pixels. */
  private static final double SLACK_PX = 2;

  /** Maximum cells along the longer side, few enough to be refilled at each update. */
  private static final int MAX_CELLS = 64;

  private final int shift;
  private final int columns;
  private final int rows;

  /** One more than the position in the list of each cluster, a byte each; 0 for no more. */
  private final long[] cells;

  ClusterGrid(SensorGeometry geometry) {
    int bits = 2;
    while (geometry.longerSide() >> bits > MAX_CELLS) {
      bits++;
    }
    shift = bits;
    columns = (geometry.width() - 1 >> shift) + 1;
    rows = (geometry.height() - 1 >> shift) + 1;
    cells = new long[columns * rows];
  }

  /** The clusters that may capture an event: 0 for none, {@link #ALL}, or bytes as above. */
  long at(int x, int y) {
    return cells[(y >> shift) * columns + (x >> shift)];
  }

  /** Updates the index of all clusters. */
  void index(Cluster[] clusters, int count) {
    Arrays.fill(cells, 0);
    for (int i = 0; i < count; i++) {
      add(clusters[i], i);
    }
  }

  /** Indexes one more cluster. */
  void add(Cluster cluster, int position) {
    cluster.indexX = cluster.x;
    cluster.indexY = cluster.y;
    int left = cell(cluster.x - cluster.extentX - SLACK_PX, columns);
    int right = cell(cluster.x + cluster.extentX + SLACK_PX, columns);
    int bottom = cell(cluster.y - cluster.extentY - SLACK_PX, rows);
    int top = cell(cluster.y + cluster.extentY + SLACK_PX, rows);
    for (int row = bottom; row <= top; row++) {
      for (int at = row * columns + left; at <= row * columns + right; at++) {
        long names = cells[at];
        boolean isFull = names >>> 7 * Byte.SIZE != 0;
        cells[at] = isFull ? ALL : names << Byte.SIZE | position + 1;
      }
    }
  }

  /** Whether a cluster has left its indexed position. */
  boolean hasLeft(Cluster cluster) {
    return Math.abs(cluster.x - cluster.indexX) > SLACK_PX
        || Math.abs(cluster.y - cluster.indexY) > SLACK_PX;
  }

  private int cell(double coordinate, int cellCount) {
    return Math.max(0, Math.min(cellCount - 1, (int) Math.floor(coordinate) >> shift));
  }
}
