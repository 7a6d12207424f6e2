package haltere.filters.track;

import haltere.filters.cluster.Cluster;
import haltere.filters.estimation.GaussianState;

/**
 * One track: the belief about its state (x, v_x, y, v_y) on a plane, and the cluster that it
 * follows. Thread rule: that of its owner.
 */
final class Track {
  final int id;
  final GaussianState belief = new GaussianState(4);

  /** Time of the belief, microseconds. */
  long timeUs;

  /** Share of the initial dynamic variances: 1 at the start, decreasing at each update. */
  double initialShare = 1;

  /** Identity of the cluster that it follows. */
  int clusterId;

  /** That cluster while it is visible, else null. */
  Cluster cluster;

  /** Last time at which the cluster was visible, microseconds. */
  long seenUs;

  /** Events of all its clusters. */
  long events;

  /** Events of the present cluster that are in {@link #events}. */
  private long counted;

  Track(int id) {
    this.id = id;
  }

  /** Follows a cluster from now on. */
  void follow(Cluster other, long nowUs) {
    cluster = other;
    clusterId = other.id();
    seenUs = nowUs;
    counted = 0;
  }

  /** Events of its cluster since the last update. */
  long newEvents() {
    return cluster == null ? 0 : cluster.eventCount() - counted;
  }

  /** Counts the events of its cluster at an update. */
  void count() {
    events += newEvents();
    counted = cluster.eventCount();
  }
}
