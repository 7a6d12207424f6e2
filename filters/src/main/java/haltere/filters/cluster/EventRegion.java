package haltere.filters.cluster;

/**
 * What an event means by where in its cluster it is, if that is to matter: in the surround it takes
 * mass away, and away from the edge it counts and does not move the cluster. Thread rule:
 * immutable.
 */
final class EventRegion {
  private final double inhibition;

  /** Squared distances, 1 at the end of the region, between which the edge is. */
  private final double edgeFrom;

  private final double edgeTo;
  private final boolean edgeOnly;

  EventRegion(ClusterTrackerSettings settings) {
    inhibition = settings.events().inhibition();
    double thickness = settings.events().edgeThickness();
    double region = ClusterForm.surround(settings);
    edgeOnly = thickness > 0;
    edgeFrom = square((1 - thickness) / region);
    edgeTo = square((1 + thickness) / region);
  }

  private static double square(double value) {
    return value * value;
  }

  /** Whether all events are alike, wherever they are. */
  boolean isUniform() {
    return inhibition == 0 && !edgeOnly;
  }

  /** Whether an event is a single cluster's also where two overlap. */
  boolean isEdgeOnly() {
    return edgeOnly;
  }

  /** Whether an event at a squared distance moves a cluster; where it does not, it is counted. */
  boolean moves(Cluster cluster, long timeUs, double distance) {
    if (inhibition > 0 && distance > cluster.surroundFrom) {
      cluster.addUp();
      // The event itself adds one again.
      cluster.mass = Math.max(0, cluster.mass - inhibition) - 1;
    }
    if (edgeOnly && (distance < edgeFrom || distance > edgeTo)) {
      cluster.count(timeUs);
      return false;
    }
    return true;
  }
}
