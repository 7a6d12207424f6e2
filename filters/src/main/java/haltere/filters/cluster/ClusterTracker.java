package haltere.filters.cluster;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.LongConsumer;

/**
 * Follows compact groups of events. An event within the radius of a cluster moves the nearest one
 * by a share m of the distance:
 *
 * <pre>x_k = (1 - m) x_(k-1) + m x_event</pre>
 *
 * <p>and one that is in no cluster begins a new one. A cluster is a mere candidate until it has had
 * enough events in a short time; then it becomes visible and gets its identity. One that gets no
 * event for longer than a lifetime dies, and two that overlap merge.
 *
 * <p>Equation and two parameters (m and the size) after J. Cardinale, "Tracking objects and wing
 * beat analysis methods of a fruit fly with the event-based silicon retina", 2006. What differs:
 * the nearest cluster takes an event, not the oldest; deaths, merging and velocities are attended
 * to every millisecond of event time, not once a packet; where there is room for no more clusters
 * the weakest candidate gives way, so that noise cannot keep a thing from being seen.
 *
 * <p>Times at which something happens are whole multiples of its interval on the clock of the
 * events; it happens after the events before that time and before those at or after it.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 */
public final class ClusterTracker {
  private static final long UPKEEP_US = 1000;

  private final SensorGeometry geometry;
  private final LongConsumer atReport;
  private ClusterTrackerSettings settings;
  private Cluster[] clusters = new Cluster[0];
  private int count;
  private int lastId;

  // Derived from the settings.
  private double radius;
  private double massDecay;
  private double velocityGain;
  private long reportUs;

  private boolean started;
  private boolean showedSomething;
  private long nextUpkeepUs;
  private long nextReportUs;

  /**
   * A tracker that has seen nothing.
   *
   * @param geometry the sensor whose events it will see
   * @param settings what to do
   * @param atReport is called at each report time, in microseconds, while there is a visible
   *     cluster and once when there is none any more; it may ask for {@link #tracks} or {@link
   *     #snapshot}
   */
  public ClusterTracker(
      SensorGeometry geometry, ClusterTrackerSettings settings, LongConsumer atReport) {
    this.geometry = Objects.requireNonNull(geometry, "geometry");
    this.atReport = Objects.requireNonNull(atReport, "atReport");
    apply(settings);
  }

  /** Forgets all clusters. Their identities are not given out again. */
  public void reset() {
    count = 0;
    started = false;
    showedSomething = false;
  }

  /**
   * What it does.
   *
   * @return the settings in force
   */
  public ClusterTrackerSettings settings() {
    return settings;
  }

  /**
   * Does something else from the next packet on, with the clusters that there are; where fewer are
   * allowed, the latest born go.
   *
   * @param newSettings the settings to use
   */
  public void apply(ClusterTrackerSettings newSettings) {
    settings = Objects.requireNonNull(newSettings, "newSettings");
    radius = Math.max(1, settings.clusterSize() * geometry.longerSide());
    massDecay = Math.exp(-(double) UPKEEP_US / settings.visibleTimeUs());
    velocityGain = 1 - Math.exp(-(double) UPKEEP_US / settings.velocityTimeUs());
    reportUs = Math.round(1e6 / settings.reportRateHz());
    Cluster[] old = clusters;
    clusters = new Cluster[settings.mostClusters()];
    for (int i = 0; i < clusters.length; i++) {
      clusters[i] = i < old.length ? old[i] : new Cluster();
    }
    count = Math.min(count, clusters.length);
    if (started) {
      nextReportUs = nextMultiple(nextUpkeepUs - UPKEEP_US, reportUs);
    }
  }

  /**
   * Takes events.
   *
   * @param packet only read
   */
  public void track(EventPacket packet) {
    int from = 0;
    while (from < packet.size()) {
      advance(packet.timeUs(from));
      int to = packet.indexAtOrAfter(Math.min(nextUpkeepUs, nextReportUs), from);
      for (int i = from; i < to; i++) {
        take(packet.x(i), packet.y(i), packet.timeUs(i));
      }
      from = to;
    }
  }

  /**
   * Where the visible clusters are.
   *
   * @return a new list, as of the last report
   */
  public List<ClusterTrack> tracks() {
    List<ClusterTrack> tracks = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      if (clusters[i].hasPath()) {
        tracks.add(clusters[i].lastRemembered());
      }
    }
    return tracks;
  }

  /**
   * Where the visible clusters are and have been.
   *
   * @param timeUs the time to write on it, microseconds
   * @return as of the last report
   */
  public ClusterSnapshot snapshot(long timeUs) {
    List<ClusterSnapshot.Trail> trails = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      if (clusters[i].hasPath()) {
        trails.add(new ClusterSnapshot.Trail(clusters[i].path()));
      }
    }
    return new ClusterSnapshot(timeUs, trails);
  }

  private void take(int x, int y, long timeUs) {
    double nearest = radius * radius;
    Cluster taker = null;
    for (int i = 0; i < count; i++) {
      Cluster cluster = clusters[i];
      double dx = x - cluster.x;
      double dy = y - cluster.y;
      double distance = dx * dx + dy * dy;
      if (distance < nearest) {
        nearest = distance;
        taker = cluster;
      }
    }
    if (taker == null) {
      begin(x, y, timeUs);
      return;
    }
    double m = settings.mixingFactor();
    taker.x += m * (x - taker.x);
    taker.y += m * (y - taker.y);
    taker.mass++;
    taker.events++;
    taker.lastUs = timeUs;
  }

  private void begin(int x, int y, long timeUs) {
    Cluster room = count < clusters.length ? clusters[count++] : weakestCandidate();
    if (room != null) {
      room.beginAt(x, y, timeUs);
    }
  }

  private Cluster weakestCandidate() {
    Cluster weakest = null;
    for (int i = 0; i < count; i++) {
      Cluster cluster = clusters[i];
      if (!cluster.isVisible()
          && (weakest == null
              || cluster.mass < weakest.mass
              || (cluster.mass == weakest.mass && cluster.lastUs < weakest.lastUs))) {
        weakest = cluster;
      }
    }
    return weakest;
  }

  /** Lets everything happen that is due until an event. */
  private void advance(long timeUs) {
    if (!started) {
      started = true;
      skipTo(timeUs);
    }
    while (Math.min(nextUpkeepUs, nextReportUs) <= timeUs) {
      if (count == 0 && !showedSomething) {
        skipTo(timeUs);
        return;
      }
      if (nextUpkeepUs <= nextReportUs) {
        upkeep(nextUpkeepUs);
        nextUpkeepUs += UPKEEP_US;
      } else {
        report(nextReportUs);
        nextReportUs += reportUs;
      }
    }
  }

  private void skipTo(long timeUs) {
    nextUpkeepUs = nextMultiple(timeUs, UPKEEP_US);
    nextReportUs = nextMultiple(timeUs, reportUs);
  }

  /** The first multiple of an interval after a time. */
  private static long nextMultiple(long timeUs, long intervalUs) {
    return (Math.floorDiv(timeUs, intervalUs) + 1) * intervalUs;
  }

  private void upkeep(long timeUs) {
    for (int i = count - 1; i >= 0; i--) {
      Cluster cluster = clusters[i];
      if (timeUs - cluster.lastUs > settings.lifetimeUs()) {
        remove(i);
      } else {
        cluster.mass *= massDecay;
      }
    }
    mergeOverlapping();
    for (int i = 0; i < count; i++) {
      Cluster cluster = clusters[i];
      if (cluster.isVisible()) {
        updateVelocity(cluster);
      } else if (cluster.mass >= settings.visibleEvents()) {
        cluster.becomeVisible(++lastId);
      }
    }
  }

  private void updateVelocity(Cluster cluster) {
    double perSecond = 1e6 / UPKEEP_US;
    cluster.vx += velocityGain * ((cluster.x - cluster.upkeepX) * perSecond - cluster.vx);
    cluster.vy += velocityGain * ((cluster.y - cluster.upkeepY) * perSecond - cluster.vy);
    cluster.upkeepX = cluster.x;
    cluster.upkeepY = cluster.y;
  }

  private void mergeOverlapping() {
    double near = 4 * radius * radius;
    for (int i = 0; i < count; i++) {
      for (int j = i + 1; j < count; j++) {
        double dx = clusters[i].x - clusters[j].x;
        double dy = clusters[i].y - clusters[j].y;
        if (dx * dx + dy * dy < near) {
          boolean first = isStronger(clusters[i], clusters[j]);
          clusters[first ? i : j].absorb(clusters[first ? j : i]);
          remove(first ? j : i);
          // The merged one has moved: look at all pairs again.
          i = -1;
          break;
        }
      }
    }
  }

  /** Whether the first of two clusters keeps its identity: a visible one, else the heavier one. */
  private static boolean isStronger(Cluster first, Cluster second) {
    if (first.isVisible() != second.isVisible()) {
      return first.isVisible();
    }
    return first.mass >= second.mass;
  }

  /** Takes a cluster out and keeps the order of the others, which is that of their births. */
  private void remove(int index) {
    Cluster removed = clusters[index];
    System.arraycopy(clusters, index + 1, clusters, index, count - index - 1);
    clusters[--count] = removed;
  }

  private void report(long timeUs) {
    boolean shows = false;
    for (int i = 0; i < count; i++) {
      Cluster cluster = clusters[i];
      if (cluster.isVisible()) {
        shows = true;
        cluster.remember(
            new ClusterTrack(
                timeUs,
                cluster.id,
                cluster.x,
                cluster.y,
                cluster.vx,
                cluster.vy,
                radius,
                cluster.events));
      }
    }
    if (shows || showedSomething) {
      showedSomething = shows;
      atReport.accept(timeUs);
    }
  }
}
