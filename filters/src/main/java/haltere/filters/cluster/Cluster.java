package haltere.filters.cluster;

import java.util.ArrayList;
import java.util.List;

/**
 * The state of one cluster, a struct that {@link ClusterTracker} works on. Made once, used again.
 */
final class Cluster {
  /** Positions that a path remembers: a second at 100 Hz. */
  private static final int PATH_LENGTH = 100;

  /** Centre, pixels. */
  double x;

  double y;

  /** Velocity, pixels a second. */
  double vx;

  double vy;

  /** Centre at the last upkeep, pixels. */
  double upkeepX;

  double upkeepY;

  /** Time of the last event taken, microseconds. */
  long lastUs;

  /** Events taken, each counting less the longer ago it was. */
  double mass;

  /** Events taken since birth. */
  long events;

  /** Identity, 0 until the cluster is visible. */
  int id;

  private final ClusterTrack[] path = new ClusterTrack[PATH_LENGTH];
  private int pathSize;
  private int pathNext;

  /** A cluster of one event. */
  void beginAt(double eventX, double eventY, long timeUs) {
    x = eventX;
    y = eventY;
    vx = 0;
    vy = 0;
    lastUs = timeUs;
    mass = 1;
    events = 1;
    id = 0;
    pathSize = 0;
    pathNext = 0;
  }

  boolean isVisible() {
    return id > 0;
  }

  /** Gives the cluster its identity and lets its motion begin here. */
  void becomeVisible(int identity) {
    id = identity;
    vx = 0;
    vy = 0;
    upkeepX = x;
    upkeepY = y;
  }

  /**
   * Takes over what another cluster has; the merged one is where their common centre of mass is.
   */
  void absorb(Cluster other) {
    double share = other.mass / (mass + other.mass);
    double dx = share * (other.x - x);
    double dy = share * (other.y - y);
    x += dx;
    y += dy;
    // The jump to the common centre is no motion.
    upkeepX += dx;
    upkeepY += dy;
    // Not the sum: noise spread over two circles would look like a thing within one.
    mass = Math.max(mass, other.mass);
    events += other.events;
    lastUs = Math.max(lastUs, other.lastUs);
  }

  void remember(ClusterTrack track) {
    path[pathNext] = track;
    pathNext = (pathNext + 1) % PATH_LENGTH;
    pathSize = Math.min(PATH_LENGTH, pathSize + 1);
  }

  /** Whether the cluster is visible and has been reported. */
  boolean hasPath() {
    return pathSize > 0;
  }

  ClusterTrack lastRemembered() {
    return path[(pathNext + PATH_LENGTH - 1) % PATH_LENGTH];
  }

  /** The path, oldest position first. */
  List<ClusterTrack> path() {
    List<ClusterTrack> positions = new ArrayList<>(pathSize);
    for (int i = pathSize; i > 0; i--) {
      positions.add(path[(pathNext + PATH_LENGTH - i) % PATH_LENGTH]);
    }
    return positions;
  }
}
