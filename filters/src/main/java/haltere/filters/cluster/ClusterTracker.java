package haltere.filters.cluster;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.ReportClock;
import haltere.filters.cluster.ClusterShapeSettings.Type;
import haltere.filters.selection.PolaritySettings.Keep;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * The cluster tracker of J. Cardinale (2006), "Tracking objects and wing beat analysis methods of a
 * fruit fly with the event-based silicon retina", part I, section 1, with the options of the
 * trackers of T. Delbruck that followed it.
 *
 * <p>An event moves the nearest cluster that contains it; one in no cluster starts a cluster if
 * there are fewer than the maximum. At each update, a whole multiple of an interval on the clock of
 * the events, clusters move by their velocity, adapt their shape, gain and lose support, merge and
 * die. An update comes after the events before its time and before those at it. So results do not
 * depend on the packets.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 */
public final class ClusterTracker {
  private static final double US = 1e-6;

  private final SensorGeometry geometry;
  private final ClusterListener listener;
  private final ClusterGrid grid;
  private final ReportClock reports = new ReportClock();
  private ClusterTrackerSettings settings;
  private ClusterShape shape;
  private ClusterUpdate update;
  private ClusterMerging merging;

  /** Clusters in the order of their births; after their number, reusable ones. */
  private Cluster[] clusters = new Cluster[0];

  private int count;
  private int lastId;
  private long eventCount;
  private boolean started;
  private long nextUpdateUs;

  // Derived from the settings.
  private boolean box;
  private boolean adaptsShape;
  private boolean uniform;
  private int ignoredPolarity;
  private double surroundFrom;
  private double edgeFrom;
  private double edgeTo;

  /**
   * A tracker in its initial state.
   *
   * @param geometry of the sensor
   * @param settings of the tracker
   * @param listener receives updates and reports
   */
  public ClusterTracker(
      SensorGeometry geometry, ClusterTrackerSettings settings, ClusterListener listener) {
    this.geometry = Objects.requireNonNull(geometry, "geometry");
    this.listener = Objects.requireNonNull(listener, "listener");
    grid = new ClusterGrid(geometry);
    apply(settings);
  }

  /** Removes all clusters. Their identities are not reused. */
  public void reset() {
    count = 0;
    started = false;
    grid.index(clusters, count);
  }

  /** The next identity is the first one again. */
  public void restartIdentities() {
    lastId = 0;
  }

  /** {@return the settings in force} */
  public ClusterTrackerSettings settings() {
    return settings;
  }

  /**
   * Applies new settings from the next packet on; existing clusters are kept, except the youngest
   * ones beyond the maximum.
   *
   * @param newSettings the settings to use
   */
  public void apply(ClusterTrackerSettings newSettings) {
    settings = Objects.requireNonNull(newSettings, "newSettings");
    shape = new ClusterShape(geometry, settings);
    update = new ClusterUpdate(geometry, settings, shape);
    merging = new ClusterMerging(settings, shape);
    box = settings.shape().type() == Type.BOX;
    adaptsShape = shape.isAdaptive();
    Keep keep = settings.events().polarity();
    ignoredPolarity = keep == Keep.BOTH ? -1 : keep == Keep.ON ? 0 : 1;
    double thickness = settings.events().edgeThickness();
    double region = shape.surround();
    surroundFrom = settings.events().inhibition() > 0 ? 1 / (region * region) : Double.MAX_VALUE;
    edgeFrom = thickness > 0 ? Math.pow((1 - thickness) / region, 2) : 0;
    edgeTo = thickness > 0 ? Math.pow((1 + thickness) / region, 2) : Double.MAX_VALUE;
    uniform = thickness == 0 && settings.events().inhibition() == 0;
    resize(settings.output().maxClusters());
    for (int i = 0; i < count; i++) {
      update.setGains(clusters[i]);
      shape.adapt(clusters[i]);
    }
    grid.index(clusters, count);
    if (started) {
      nextUpdateUs = nextMultiple(nextUpdateUs - 1);
    }
    reports.setRate(settings.output().reportRateHz());
  }

  private void resize(int maxClusters) {
    Cluster[] before = clusters;
    clusters = new Cluster[maxClusters];
    count = Math.min(count, maxClusters);
    for (int i = 0; i < maxClusters; i++) {
      clusters[i] = i < before.length ? before[i] : new Cluster();
    }
  }

  /** {@return how many clusters there are, visible or not, at least 0} */
  public int count() {
    return count;
  }

  /** {@return events of all past and present clusters, a count up to the last update} */
  public long eventCount() {
    return eventCount;
  }

  /**
   * {@return one of the clusters, in the order of their births, the same object as long as it
   * lives}
   *
   * @param index from 0
   */
  public Cluster cluster(int index) {
    return clusters[Objects.checkIndex(index, count)];
  }

  /**
   * Moves a cluster, for feedback from a filter; to be called at an update only.
   *
   * @param cluster a present one
   * @param xPx column, pixels, finite
   * @param yPx row, pixels, finite
   */
  public void move(Cluster cluster, double xPx, double yPx) {
    if (Double.isFinite(xPx) && Double.isFinite(yPx)) {
      cluster.x = xPx;
      cluster.y = yPx;
    }
  }

  /**
   * {@return the visible clusters at a time, a new list}
   *
   * @param timeUs time of a report, or now, microseconds
   */
  public List<ClusterTrack> tracks(long timeUs) {
    List<ClusterTrack> tracks = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      if (clusters[i].visible) {
        double sinceS = US * (timeUs - clusters[i].updatedUs);
        tracks.add(clusters[i].track(timeUs, settings.motion().predict() ? sinceS : 0));
      }
    }
    return tracks;
  }

  /**
   * Processes events.
   *
   * @param packet only read, unless events outside clusters are to be removed
   */
  public void track(EventPacket packet) {
    long[] timesUs = packet.timesUs();
    int[] addresses = packet.addresses();
    boolean removes = settings.output().onlyClustered();
    int passed = 0;
    int from = 0;
    while (from < packet.size()) {
      advance(timesUs[from]);
      int to = packet.indexAtOrAfter(Math.min(nextUpdateUs, reports.nextUs()), from);
      for (int i = from; i < to; i++) {
        Cluster cluster = take(addresses[i], timesUs[i]);
        if (removes && cluster != null && cluster.visible) {
          packet.move(i, passed++);
        }
      }
      from = to;
    }
    if (removes) {
      packet.truncate(passed);
    }
  }

  /** Assigns an event to the nearest cluster that contains it; null if there is none. */
  private Cluster take(int address, long timeUs) {
    if ((address & EventAddress.ON_BIT) == ignoredPolarity) {
      return null;
    }
    int x = EventAddress.x(address);
    int y = EventAddress.y(address);
    long names = grid.at(x, y);
    Cluster nearest = null;
    double minPx2 = Double.MAX_VALUE;
    if (names == ClusterGrid.ALL) {
      for (int i = 0; i < count; i++) {
        double px2 = distancePx2(clusters[i], x, y);
        nearest = px2 < minPx2 ? clusters[i] : nearest;
        minPx2 = Math.min(minPx2, px2);
      }
    } else {
      for (; names != 0; names >>>= Byte.SIZE) {
        Cluster cluster = clusters[(int) (names & 0xff) - 1];
        double px2 = distancePx2(cluster, x, y);
        nearest = px2 < minPx2 ? cluster : nearest;
        minPx2 = Math.min(minPx2, px2);
      }
    }
    if (nearest == null) {
      if (count < clusters.length) {
        start(x, y, timeUs);
      }
      return null;
    }
    take(nearest, x - nearest.x, y - nearest.y);
    return nearest;
  }

  /** Squared distance of an event from the centre of a cluster that contains it, else infinite. */
  private double distancePx2(Cluster cluster, int x, int y) {
    double dx = x - cluster.x;
    double dy = y - cluster.y;
    return cluster.distance(dx, dy, box) <= 1 ? dx * dx + dy * dy : Double.POSITIVE_INFINITY;
  }

  private void take(Cluster cluster, double dx, double dy) {
    if (!uniform) {
      double distance = cluster.distance(dx, dy, box);
      if (distance > surroundFrom) {
        cluster.inhibited += settings.events().inhibition() + 1;
      }
      if (distance < edgeFrom || distance > edgeTo) {
        cluster.fresh++;
        return;
      }
    }
    cluster.take(dx, dy);
    if (adaptsShape) {
      cluster.adaptShape(dx, dy);
    }
    if (grid.hasLeft(cluster)) {
      grid.index(clusters, count);
    }
  }

  /** Starts a cluster at an event. */
  private void start(int x, int y, long timeUs) {
    Cluster born = clusters[count];
    update.start(born, clusters, count, timeUs);
    born.x = x;
    born.y = y;
    shape.start(born);
    update.setGains(born);
    grid.add(born, count);
    count++;
  }

  /** Does the work due until a time. */
  private void advance(long timeUs) {
    if (!started) {
      started = true;
      skipTo(timeUs);
    }
    while (Math.min(nextUpdateUs, reports.nextUs()) <= timeUs) {
      if (count == 0 && !listener.isWaiting()) {
        skipTo(timeUs);
      } else if (nextUpdateUs <= reports.nextUs()) {
        update(nextUpdateUs);
        nextUpdateUs += settings.output().updateIntervalUs();
      } else {
        long reportUs = reports.nextUs();
        reports.advance();
        listener.reported(reportUs);
      }
    }
  }

  /** Skips the work due until a time. */
  private void skipTo(long timeUs) {
    nextUpdateUs = nextMultiple(timeUs);
    reports.skipTo(timeUs + 1);
  }

  /** The first time of an update after a time. */
  private long nextMultiple(long timeUs) {
    long intervalUs = settings.output().updateIntervalUs();
    return (Math.floorDiv(timeUs, intervalUs) + 1) * intervalUs;
  }

  private void update(long timeUs) {
    update.limitSpeeds(clusters, count);
    for (int i = 0; i < count; i++) {
      eventCount += clusters[i].fresh;
      update.update(clusters[i], timeUs);
    }
    for (int i = 0; i < count; i++) {
      for (int j = i + 1; j < count; j++) {
        if (merging.areOne(clusters[i], clusters[j], timeUs)) {
          boolean firstStays = ClusterMerging.isStronger(clusters[i], clusters[j]);
          merging.merge(clusters[firstStays ? i : j], clusters[firstStays ? j : i]);
          remove(firstStays ? j : i);
          // the merged cluster may overlap one that was compared before
          i = 0;
          j = 0;
        }
      }
    }
    for (int i = count - 1; i >= 0; i--) {
      if (update.isDead(clusters[i], timeUs)) {
        remove(i);
      }
    }
    for (int i = 0; i < count; i++) {
      if (clusters[i].visible && clusters[i].id == 0) {
        clusters[i].id = ++lastId;
      }
    }
    listener.updated(timeUs);
    grid.index(clusters, count);
  }

  /** Removes a cluster; the order of the others stays. */
  private void remove(int index) {
    Cluster removed = clusters[index];
    System.arraycopy(clusters, index + 1, clusters, index, count - index - 1);
    clusters[--count] = removed;
  }
}
