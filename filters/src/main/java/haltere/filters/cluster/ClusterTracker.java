package haltere.filters.cluster;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.filters.selection.PolaritySettings.Keep;
import java.util.ArrayList;
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
  private static final long NEVER = Long.MAX_VALUE;

  /** A second cluster that is less likely by more than this has no share in an event. */
  private static final double LEAST_SHARE = 0.02;

  private final SensorGeometry geometry;
  private final LongConsumer atReport;
  private final ClusterGrid grid;
  private final ClusterMerging merging = new ClusterMerging();
  private final ClusterReader reader = new ClusterReader(merging);
  private ClusterTrackerSettings settings;
  private ClusterMotion motion;
  private ClusterForm form;
  private ClusterLife life;
  private BirthPlaces places;
  private Cluster[] clusters = new Cluster[0];
  private int count;
  private int lastId;
  private ClusterObserver observer;

  // Derived from the settings.
  private long upkeepUs;
  private long reportUs;
  private long observeUs;
  private boolean box;
  private boolean onlyClustered;
  private int otherPolarity;
  private double inhibition;

  private boolean started;
  private boolean showedSomething;
  private boolean observedSomething;
  private long nextUpkeepUs;
  private long nextReportUs;
  private long nextObservationUs = NEVER;

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
    grid = new ClusterGrid(geometry);
    apply(settings);
  }

  /** Forgets all clusters. Their identities are not given out again. */
  public void reset() {
    count = 0;
    started = false;
    showedSomething = false;
    observedSomething = false;
    places.reset();
    merging.reset();
    grid.index(clusters, 0, 0);
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
    reportUs = Math.round(1e6 / settings.output().reportRateHz());
    onlyClustered = settings.output().onlyClustered();
    inhibition = settings.events().inhibition();
    Keep keep = settings.events().polarity();
    otherPolarity = keep == Keep.BOTH ? -1 : keep == Keep.ON ? 0 : 1;
    motion = new ClusterMotion(settings);
    form = new ClusterForm(geometry, settings);
    box = form.isBox();
    places = new BirthPlaces(geometry, form.startRadius());
    places.apply(settings);
    life = new ClusterLife(geometry, settings, places);
    makeRoom(settings.output().mostClusters());
    for (Cluster cluster : clusters) {
      cluster.path.setMost(settings.output().pathPoints());
    }
    for (int i = 0; i < count; i++) {
      form.upkeep(clusters[i], clusters[i].atUs, 0);
      motion.setGains(clusters[i]);
    }
    index();
    if (started) {
      long nowUs = nextUpkeepUs - 1;
      nextUpkeepUs = nextMultiple(nowUs, upkeepUs);
      nextReportUs = nextMultiple(nowUs, reportUs);
    }
  }

  private void makeRoom(int most) {
    merging.apply(settings.merging(), most);
    if (most == clusters.length) {
      return;
    }
    count = Math.min(count, most);
    Cluster[] old = clusters;
    clusters = new Cluster[most];
    boolean[] taken = new boolean[most];
    int kept = 0;
    for (int i = 0; i < count; i++) {
      if (old[i].slot < most) {
        taken[old[i].slot] = true;
        clusters[kept++] = old[i];
      }
    }
    count = kept;
    for (int slot = 0; slot < most; slot++) {
      if (!taken[slot]) {
        clusters[kept++] = new Cluster(slot);
      }
    }
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
    observeUs = intervalUs;
    observedSomething = false;
    nextObservationUs =
        observer == null || !started ? NEVER : nextMultiple(nextUpkeepUs - upkeepUs, observeUs);
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
      int to = packet.indexAtOrAfter(nextUs(), from);
      if (onlyClustered) {
        for (int i = from; i < to; i++) {
          if (take(addresses[i], timesUs[i])) {
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
    List<ClusterTrack> tracks = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      if (isReported(clusters[i])) {
        tracks.add(clusters[i].path.last(clusters[i].id));
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
      if (isReported(clusters[i])) {
        trails.add(new ClusterSnapshot.Trail(clusters[i].path.list(clusters[i].id)));
      }
    }
    return new ClusterSnapshot(timeUs, trails);
  }

  private static boolean isReported(Cluster cluster) {
    return cluster.isVisible() && !cluster.path.isEmpty();
  }

  /** Takes an event, and says whether it is in a visible cluster. */
  private boolean take(int address, long timeUs) {
    if ((address & EventAddress.ON_BIT) == otherPolarity) {
      return false;
    }
    int x = EventAddress.x(address);
    int y = EventAddress.y(address);
    int sign = 2 * (address & EventAddress.ON_BIT) - 1;
    int cell = grid.cellOf(x, y);
    int candidates = grid.count(cell);
    if (candidates == 1) {
      Cluster cluster = clusters[grid.name(cell, 0)];
      double distance = cluster.distance(x, y, timeUs, box);
      if (distance < 1) {
        give(cluster, x, y, sign, timeUs, distance);
        return cluster.isVisible();
      }
    } else if (candidates > 1) {
      Cluster taker = contest(cell, candidates, x, y, sign, timeUs);
      if (taker != null) {
        return taker.isVisible();
      }
    }
    if (places.add(x, y, timeUs)) {
      birth(x, y, timeUs);
    }
    return false;
  }

  private void give(Cluster cluster, int x, int y, int sign, long timeUs, double distance) {
    cluster.take(x, y, sign, timeUs);
    if (inhibition > 0 && distance > cluster.surroundFrom) {
      cluster.mass = Math.max(0, cluster.mass - 1 - inhibition);
    }
    if (cluster.hasLeftIndex()) {
      index();
    }
  }

  /** Shares an event among the two clusters that it is most likely to belong to. */
  private Cluster contest(int cell, int candidates, int x, int y, int sign, long timeUs) {
    Cluster first = null;
    Cluster second = null;
    double firstDistance = 0;
    double best = 0;
    double next = 0;
    int all = candidates == ClusterGrid.ALL ? count : candidates;
    for (int i = 0; i < all; i++) {
      Cluster cluster = clusters[candidates == ClusterGrid.ALL ? i : grid.name(cell, i)];
      double distance = cluster.distance(x, y, timeUs, box);
      if (distance < 1) {
        double likelihood = cluster.likelihood(x, y, sign, timeUs);
        if (likelihood > best) {
          second = first;
          next = best;
          first = cluster;
          best = likelihood;
          firstDistance = distance;
        } else if (likelihood > next) {
          second = cluster;
          next = likelihood;
        }
      }
    }
    if (first == null) {
      return null;
    }
    double share = next / (best + next);
    if (second == null || share < LEAST_SHARE) {
      give(first, x, y, sign, timeUs, firstDistance);
    } else {
      first.take(x, y, sign, timeUs, 1 - share);
      second.take(x, y, sign, timeUs, share);
      if (first.hasLeftIndex() || second.hasLeftIndex()) {
        index();
      }
    }
    return first;
  }

  private void birth(int x, int y, long timeUs) {
    Cluster born = count < clusters.length ? clusters[count++] : life.weakest(clusters, count);
    if (born == null) {
      places.clearBirth(x, y);
      return;
    }
    merging.forget(born);
    life.begin(born, clusters, count, timeUs);
    form.begin(born);
    motion.begin(born, places.bornEvents(), (timeUs - places.bornFirstUs()) * 1e-6);
    places.clearBirth(x, y);
    index();
  }

  private void index() {
    grid.index(clusters, count, upkeepUs * 1e-6);
  }

  private long nextUs() {
    return Math.min(Math.min(nextUpkeepUs, nextReportUs), nextObservationUs);
  }

  /** Lets everything happen that is due until an event. */
  private void advance(long timeUs) {
    if (!started) {
      started = true;
      skipTo(timeUs);
    }
    while (nextUs() <= timeUs) {
      if (isIdle()) {
        skipTo(timeUs);
        return;
      }
      if (nextUpkeepUs == nextUs()) {
        upkeep(nextUpkeepUs);
        nextUpkeepUs += upkeepUs;
      } else if (nextObservationUs == nextUs()) {
        observation(nextObservationUs);
        nextObservationUs += observeUs;
      } else {
        report(nextReportUs);
        nextReportUs += reportUs;
      }
    }
  }

  /** Whether nothing can happen until the next event. */
  private boolean isIdle() {
    return count == 0
        && !showedSomething
        && !observedSomething
        && places.areForgotten()
        && (observer == null || !observer.isWaiting());
  }

  private void skipTo(long timeUs) {
    nextUpkeepUs = nextMultiple(timeUs, upkeepUs);
    nextReportUs = nextMultiple(timeUs, reportUs);
    nextObservationUs = observer == null ? NEVER : nextMultiple(timeUs, observeUs);
  }

  /** The first multiple of an interval after a time. */
  private static long nextMultiple(long timeUs, long intervalUs) {
    return (Math.floorDiv(timeUs, intervalUs) + 1) * intervalUs;
  }

  private void upkeep(long timeUs) {
    life.measureNoise(clusters, count);
    for (int i = count - 1; i >= 0; i--) {
      Cluster cluster = clusters[i];
      cluster.moveTo(timeUs);
      if (life.isOver(cluster, timeUs)) {
        remove(i);
      } else {
        motion.upkeep(cluster, timeUs);
        form.upkeep(cluster, timeUs, life.noiseShare(cluster));
        if (count < clusters.length && form.isParting(cluster, timeUs)) {
          part(cluster, timeUs);
        }
      }
    }
    merge(timeUs);
    for (int i = 0; i < count; i++) {
      if (!clusters[i].isVisible() && life.isToBeSeen(clusters[i], timeUs)) {
        clusters[i].id = ++lastId;
      }
    }
    index();
  }

  private void part(Cluster cluster, long timeUs) {
    Cluster born = clusters[count++];
    merging.forget(born);
    life.part(cluster, born, timeUs);
    form.part(cluster, born, timeUs);
    motion.part(cluster, born);
    merging.parted(cluster, born);
  }

  private void merge(long timeUs) {
    for (int i = 0; i < count; i++) {
      clusters[i].overlapped = false;
    }
    for (int i = 0; i < count; i++) {
      for (int j = i + 1; j < count; j++) {
        if (merging.unite(clusters[i], clusters[j], timeUs, (int) upkeepUs)) {
          boolean firstStays = ClusterMerging.isStronger(clusters[i], clusters[j]);
          Cluster kept = clusters[firstStays ? i : j];
          Cluster lost = clusters[firstStays ? j : i];
          merging.absorb(kept, lost);
          form.settle(kept, timeUs);
          if (observer != null && kept.isVisible() && lost.isVisible()) {
            observer.clustersMerged(timeUs, kept.id, lost.id);
          }
          remove(firstStays ? j : i);
          // The others are looked at in the next upkeep.
          return;
        }
      }
    }
  }

  /** Takes a cluster out and keeps the order of the others, which is that of their births. */
  private void remove(int index) {
    Cluster removed = clusters[index];
    System.arraycopy(clusters, index + 1, clusters, index, count - index - 1);
    clusters[--count] = removed;
  }

  private void observation(long timeUs) {
    reader.open(clusters, count, timeUs, geometry.width(), geometry.height());
    boolean something = reader.count() > 0;
    if (something || observedSomething || observer.isWaiting()) {
      observedSomething = something;
      observer.clustersRead(timeUs, reader);
    }
    reader.close();
    if (reader.wasFedBack()) {
      index();
    }
  }

  private void report(long timeUs) {
    boolean shows = false;
    for (int i = 0; i < count; i++) {
      Cluster cluster = clusters[i];
      if (cluster.isVisible()) {
        shows = true;
        cluster.moveTo(timeUs);
        cluster.path.add(cluster, timeUs);
      }
    }
    if (shows || showedSomething) {
      showedSomething = shows;
      atReport.accept(timeUs);
    }
  }
}
