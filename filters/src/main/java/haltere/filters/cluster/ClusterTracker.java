package haltere.filters.cluster;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.filters.selection.PolaritySettings.Keep;
import java.util.List;
import java.util.Objects;
import java.util.function.LongConsumer;

/**
 * Follows compact groups of events: things that move.
 *
 * <p>An event within the region of a cluster moves it. Events in no cluster gather at {@link
 * BirthPlaces}, and where there are more than noise makes a cluster is born: noise needs no
 * clusters and takes no room. A cluster becomes visible, and gets its identity, when it has enough
 * recent events; it dies when it has had none, or no more than noise, for a lifetime. What moves it
 * is {@link ClusterMotion}, how large it is {@link ClusterForm}, which clusters become one {@link
 * ClusterMerging}; which may take an event at all a {@link ClusterGrid} knows.
 *
 * <p>Where the regions of clusters overlap, an event is shared among those that it is in, by how
 * likely it is each one's given where their ON and OFF events have been. To give it to the nearest
 * would push clusters that meet apart; shared, they go through each other.
 *
 * <p>The idea of clusters that events move, and most of the settings, come from J. Cardinale,
 * "Tracking objects and wing beat analysis methods of a fruit fly with the event-based silicon
 * retina", 2006, and from T. Delbruck's trackers that followed it.
 *
 * <p>Times at which something happens are whole multiples of its interval on the clock of the
 * events; it happens after the events before that time and before those at or after it. So results
 * do not depend on how the stream is cut into packets.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 */
public final class ClusterTracker {
  /** A second cluster that is less likely by more than this has no share in an event. */
  private static final double LEAST_SHARE = 0.02;

  private final SensorGeometry geometry;
  private final Clusters clusters = new Clusters();
  private final ClusterTimes times = new ClusterTimes();
  private final ClusterReports reports;
  private final ClusterGrid grid;
  private final ClusterMerging merging = new ClusterMerging();
  private final ClusterUpkeep upkeep;
  private final ClusterReader reader = new ClusterReader(merging);
  private ClusterTrackerSettings settings;
  private ClusterMotion motion;
  private ClusterForm form;
  private ClusterLife life;
  private BirthPlaces places;
  private ClusterObserver observer;

  // Derived from the settings.
  private long upkeepUs;
  private boolean box;
  private boolean onlyClustered;
  private int otherPolarity;
  private EventRegion region;
  private boolean uniform;
  private double leastShare;

  private boolean observedSomething;

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
    reports = new ClusterReports(clusters, Objects.requireNonNull(atReport, "atReport"));
    grid = new ClusterGrid(geometry);
    ClusterLines lines = new ClusterLines(geometry.width(), geometry.height());
    upkeep = new ClusterUpkeep(clusters, merging, lines);
    apply(settings);
  }

  /** Forgets all clusters. Their identities are not given out again. */
  public void reset() {
    clusters.count = 0;
    times.reset();
    reports.reset();
    observedSomething = false;
    places.reset();
    merging.reset();
    index();
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
    upkeepUs = settings.output().upkeepUs();
    onlyClustered = settings.output().onlyClustered();
    region = new EventRegion(settings);
    uniform = region.isUniform();
    leastShare = region.isEdgeOnly() ? 1 : LEAST_SHARE;
    Keep keep = settings.events().polarity();
    otherPolarity = keep == Keep.BOTH ? -1 : keep == Keep.ON ? 0 : 1;
    motion = new ClusterMotion(settings);
    form = new ClusterForm(geometry, settings);
    box = form.isBox();
    places = new BirthPlaces(geometry, form.startRadius());
    places.apply(settings);
    life = new ClusterLife(geometry, settings, places);
    SpeedLimit limit = new SpeedLimit(settings.motion().velocity().neighbourRadii());
    upkeep.apply(motion, form, life, limit, (int) upkeepUs);
    merging.apply(settings.merging(), settings.output().mostClusters());
    clusters.setMost(settings.output().mostClusters());
    for (Cluster cluster : clusters.all) {
      cluster.path.setMost(settings.output().pathPoints());
    }
    for (int i = 0; i < clusters.count; i++) {
      Cluster cluster = clusters.all[i];
      cluster.addUp();
      form.upkeep(cluster, cluster.atUs, 0);
      motion.setGains(cluster);
    }
    index();
    times.apply(upkeepUs, Math.round(1e6 / settings.output().reportRateHz()));
  }

  /**
   * Sets who hears of the visible clusters.
   *
   * @param newObserver takes the place of the one before; null for nobody
   * @param intervalUs time between two readings, microseconds, at least 1
   */
  public void observe(ClusterObserver newObserver, long intervalUs) {
    if (intervalUs < 1) {
      throw new IllegalArgumentException("an interval is at least 1 us, not " + intervalUs);
    }
    observer = newObserver;
    observedSomething = false;
    times.observe(observer == null ? 0 : intervalUs);
  }

  /**
   * Takes events.
   *
   * @param packet only read, unless events outside clusters are to be taken out
   */
  public void track(EventPacket packet) {
    long[] timesUs = packet.timesUs();
    int[] addresses = packet.addresses();
    int kept = 0;
    int from = 0;
    while (from < packet.size()) {
      advance(timesUs[from]);
      int to = packet.indexAtOrAfter(times.nextUs(), from);
      if (onlyClustered) {
        for (int i = from; i < to; i++) {
          Cluster taker = take(addresses[i], timesUs[i]);
          if (taker != null && taker.isVisible()) {
            packet.move(i, kept++);
          }
        }
      } else {
        for (int i = from; i < to; i++) {
          take(addresses[i], timesUs[i]);
        }
      }
      from = to;
    }
    if (onlyClustered) {
      packet.truncate(kept);
    }
  }

  /**
   * Where the visible clusters are.
   *
   * @return a new list, as of the last report
   */
  public List<ClusterTrack> tracks() {
    return reports.tracks();
  }

  /**
   * Where the visible clusters are and have been.
   *
   * @param timeUs the time to write on it, microseconds
   * @return as of the last report
   */
  public ClusterSnapshot snapshot(long timeUs) {
    return reports.snapshot(timeUs);
  }

  /** Takes an event, and says which cluster it is in, or null. */
  private Cluster take(int address, long timeUs) {
    if ((address & EventAddress.ON_BIT) == otherPolarity) {
      return null;
    }
    int x = EventAddress.x(address);
    int y = EventAddress.y(address);
    int sign = 2 * (address & EventAddress.ON_BIT) - 1;
    int cell = grid.at(x, y);
    if (cell != 0) {
      Cluster taker =
          ClusterGrid.count(cell) == 1
              ? takeAlone(clusters.all[ClusterGrid.name(cell, 0)], x, y, sign, timeUs)
              : takeOfMany(cell, x, y, sign, timeUs);
      if (taker != null) {
        return taker;
      }
    }
    if (places.add(x, y, timeUs)) {
      birth(x, y, timeUs);
    }
    return null;
  }

  /** Gives an event to a cluster if it is in its region, else to none, which is null. */
  private Cluster takeAlone(Cluster only, int x, int y, int sign, long timeUs) {
    double distance = only.distance(x, y, timeUs, box);
    if (!(distance < 1)) {
      return null;
    }
    give(only, x, y, sign, timeUs, distance);
    return only;
  }

  /** Shares an event among the two clusters that it is most likely to belong to. */
  private Cluster takeOfMany(int cell, int x, int y, int sign, long timeUs) {
    Cluster first = null;
    Cluster second = null;
    double firstDistance = 0;
    // Not worked out as long as there is only one.
    double best = Double.NaN;
    double next = 0;
    boolean all = cell == ClusterGrid.ALL;
    int candidates = all ? clusters.count : ClusterGrid.count(cell);
    for (int i = 0; i < candidates; i++) {
      Cluster cluster = clusters.all[all ? i : ClusterGrid.name(cell, i)];
      double distance = cluster.distance(x, y, timeUs, box);
      if (!(distance < 1)) {
        continue;
      }
      if (first == null) {
        first = cluster;
        firstDistance = distance;
        continue;
      }
      if (second == null) {
        best = first.likelihood(x, y, sign, timeUs);
      }
      double likelihood = cluster.likelihood(x, y, sign, timeUs);
      if (likelihood > best) {
        second = first;
        next = best;
        first = cluster;
        best = likelihood;
        firstDistance = distance;
      } else if (second == null || likelihood > next) {
        second = cluster;
        next = likelihood;
      }
    }
    if (second != null) {
      share(first, second, x, y, sign, timeUs, best, next, firstDistance);
    } else if (first != null) {
      give(first, x, y, sign, timeUs, firstDistance);
    }
    return first;
  }

  /**
   * Shares an event among two by how likely it is each one's, unless the second is too unlikely.
   */
  private void share(
      Cluster first,
      Cluster second,
      int x,
      int y,
      int sign,
      long timeUs,
      double best,
      double next,
      double firstDistance) {
    double share = next / (best + next);
    if (!(share >= leastShare)) {
      give(first, x, y, sign, timeUs, firstDistance);
      return;
    }
    first.take(x, y, sign, timeUs, 1 - share);
    second.take(x, y, sign, timeUs, share);
    if (first.hasLeftIndex() || second.hasLeftIndex()) {
      index();
    }
  }

  private void give(Cluster cluster, int x, int y, int sign, long timeUs, double distance) {
    if (uniform || region.moves(cluster, timeUs, distance)) {
      cluster.take(x, y, sign, timeUs);
    }
    if (cluster.hasLeftIndex()) {
      index();
    }
  }

  private void birth(int x, int y, long timeUs) {
    Cluster born = clusters.isFull() ? life.weakest(clusters) : clusters.add();
    if (born == null) {
      places.clearBirth(x, y);
      return;
    }
    merging.forget(born);
    life.begin(born, clusters, timeUs);
    form.begin(born);
    motion.begin(born, places.bornEvents(), (timeUs - places.bornFirstUs()) * 1e-6);
    places.clearBirth(x, y);
    index();
  }

  private void index() {
    grid.index(clusters, upkeepUs * 1e-6);
  }

  /** Lets everything happen that is due until an event. */
  private void advance(long timeUs) {
    times.startAt(timeUs);
    while (times.nextUs() <= timeUs) {
      if (isIdle()) {
        times.skipTo(timeUs);
        return;
      }
      if (times.isUpkeepNext()) {
        upkeep.run(times.takeUpkeep(), observer);
        grid.refresh(clusters, upkeepUs * 1e-6);
      } else if (times.isObservationNext()) {
        observation(times.takeObservation());
      } else {
        reports.report(times.takeReport());
      }
    }
  }

  /** Whether nothing can happen until the next event. */
  private boolean isIdle() {
    return clusters.count == 0
        && !reports.isShowing()
        && !observedSomething
        && places.areForgotten()
        && (observer == null || !observer.isWaiting(times.nextUs()));
  }

  private void observation(long timeUs) {
    reader.open(clusters.all, clusters.count, timeUs, geometry.width(), geometry.height());
    boolean something = reader.count() > 0;
    if (something || observedSomething || observer.isWaiting(timeUs)) {
      observedSomething = something;
      observer.clustersRead(timeUs, reader);
    }
    reader.close();
    if (reader.wasFedBack()) {
      grid.refresh(clusters, upkeepUs * 1e-6);
    }
  }
}
