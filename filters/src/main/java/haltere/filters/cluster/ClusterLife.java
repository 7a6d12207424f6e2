package haltere.filters.cluster;

import haltere.core.event.SensorGeometry;
import haltere.filters.cluster.ClusterLifeSettings.Border;
import haltere.filters.cluster.ClusterLifeSettings.Visibility;
import haltere.filters.cluster.ClusterVelocitySettings.Start;

/** Births, visibility and deaths of clusters. */
final class ClusterLife {
  /** Recent events below which a cluster has no support, whatever noise there is. */
  private static final double LEAST_SUPPORT = 4;

  /** Standard deviations of a Poisson count above noise, to be seen and to be supported. */
  private static final double SEEN_SIGMAS = 4;

  private static final double SUPPORTED_SIGMAS = 3;

  /** How many times as many events as noise makes, to be seen and to be supported. */
  private static final double SEEN_CONTRAST = 1.6;

  private static final double SUPPORTED_CONTRAST = 1.3;

  /** A thing that makes fewer than this share of the events that it usually makes is gone. */
  private static final double LEAST_OF_USUAL = 0.12;

  /** Standard deviations of a velocity above the least one, to be seen. */
  private static final double SURE_SPEED_SIGMAS = 3;

  private static final double USUAL_TIME_US = 500_000;

  /** A cluster with fewer than this many times the events of noise may be noise. */
  private static final double THIN = 2;

  /** How many radii from another cluster a newborn one may be a part of it. */
  private static final double BESIDE = 2;

  /** The same later, when both are nearer to their own size, where the other is no large thing. */
  private static final double STILL_BESIDE = 1.5;

  /** What stays beside another cluster is seen when it has not become one with it in this time. */
  private static final long PARTING_US = 60_000;

  private static final double MOST_NOISE = 0.9;

  /** A cluster that was never seen does not live on for longer than this without support. */
  private static final long UNSEEN_LIFETIME_US = 20_000;

  private final ClusterLifeSettings settings;
  private final BirthPlaces places;
  private final Start start;
  private final double massDecay;
  private final double usualGain;
  private final double right;
  private final double top;

  ClusterLife(SensorGeometry geometry, ClusterTrackerSettings all, BirthPlaces places) {
    settings = all.life();
    this.places = places;
    start = all.motion().velocity().start();
    massDecay = StrictMath.exp(-(double) all.output().upkeepUs() / settings.recentUs());
    usualGain = 1 - StrictMath.exp(-all.output().upkeepUs() / USUAL_TIME_US);
    right = geometry.width() - 0.5;
    top = geometry.height() - 0.5;
  }

  /** Begins a life at the place of birth that was found last. */
  void begin(Cluster born, Clusters clusters, long timeUs) {
    startAnew(born, timeUs);
    born.x = places.bornX();
    born.y = places.bornY();
    born.mass = places.bornEvents();
    born.usualMass = 0;
    born.events = Math.round(places.bornEvents());
    born.unseenUntilUs = isBeside(born, BESIDE, clusters) ? timeUs + PARTING_US : Long.MIN_VALUE;
    born.overlapped = false;
    setVelocity(born, clusters);
  }

  /**
   * Parts a cluster that has grown over two things: it stays where more of its events are, for what
   * seems to be the other place may be nothing; the newborn one is there.
   */
  void part(Cluster cluster, Cluster born, long timeUs) {
    double between = ClusterForm.WITHIN * cluster.square;
    double root = Math.sqrt(between);
    double skewness = cluster.cube / (between * root);
    double ahead = 0.5 * (skewness + Math.sqrt(skewness * skewness + 4));
    double share = 1 / (1 + ahead * ahead);
    double bornAt = ahead * root;
    double stayAt = -root / ahead;
    if (share > 0.5) {
      share = 1 - share;
      double place = bornAt;
      bornAt = stayAt;
      stayAt = place;
    }
    part(cluster, born, share, timeUs);
    born.x = cluster.x + bornAt * cluster.cos;
    born.y = cluster.y + bornAt * cluster.sin;
    born.vx = cluster.vx;
    born.vy = cluster.vy;
    cluster.x += stayAt * cluster.cos;
    cluster.y += stayAt * cluster.sin;
  }

  /** Gives a newborn cluster a share of the life of the one that it was a part of. */
  void part(Cluster cluster, Cluster born, double share, long timeUs) {
    startAnew(born, timeUs);
    born.events = Math.round(share * cluster.events);
    born.mass = share * cluster.mass;
    born.unseenUntilUs = timeUs + PARTING_US;
    born.overlapped = true;
    born.usualMass = share * cluster.usualMass;
    cluster.contour.end();
    cluster.clearBatch(timeUs);
    cluster.mass *= 1 - share;
    cluster.usualMass *= 1 - share;
  }

  /** Forgets whatever was in a newborn cluster's slot before. */
  private static void startAnew(Cluster born, long timeUs) {
    born.id = 0;
    born.taken = 0;
    born.bornUs = timeUs;
    born.lastUs = timeUs;
    born.atUs = timeUs;
    born.supportedUs = timeUs;
    born.keptUntilUs = Long.MIN_VALUE;
    born.path.clear();
    born.contour.end();
    born.probe.end();
    born.lineX = 0;
    born.lineY = 0;
    born.clearBatch(timeUs);
  }

  /**
   * Whether a cluster is so near to another one that it may be a part of it. Parts appear beside
   * what has been there for a while and has no round outline.
   */
  private static boolean isBeside(Cluster born, double radii, Clusters clusters) {
    for (int i = 0; i < clusters.count; i++) {
      Cluster other = clusters.all[i];
      boolean mayBeLarge =
          !other.contour.isPlaced() && born.bornUs - other.bornUs > ClusterForm.SETTLED_US;
      double reach = mayBeLarge ? BESIDE : radii;
      if (other != born
          && Math.abs(other.x - born.x) < reach * other.extentX
          && Math.abs(other.y - born.y) < reach * other.extentY) {
        return true;
      }
    }
    return false;
  }

  private void setVelocity(Cluster born, Clusters clusters) {
    born.vx = 0;
    born.vy = 0;
    double visible = 0;
    double vx = 0;
    double vy = 0;
    if (start == Start.EVENTS) {
      places.setVelocity(born);
    }
    for (int i = 0; start == Start.MEAN && i < clusters.count; i++) {
      if (clusters.all[i].isVisible() && clusters.all[i] != born) {
        visible++;
        vx += clusters.all[i].vx;
        vy += clusters.all[i].vy;
      }
    }
    if (visible > 0) {
      born.vx = vx / visible;
      born.vy = vy / visible;
    }
  }

  /** Takes away the age of its events' weights, and says whether the cluster is to die. */
  boolean isOver(Cluster cluster, long timeUs) {
    cluster.mass *= massDecay;
    cluster.usualMass += usualGain * (cluster.mass - cluster.usualMass);
    double noise = noise(cluster);
    double least =
        Math.max(
            Math.max(LEAST_SUPPORT, LEAST_OF_USUAL * cluster.usualMass),
            moreThan(noise, SUPPORTED_CONTRAST, SUPPORTED_SIGMAS));
    if (cluster.mass > least) {
      cluster.supportedUs = timeUs;
    }
    if (isOutside(cluster)) {
      return true;
    }
    long silentUs = timeUs - cluster.lastUs;
    long weakUs = timeUs - cluster.supportedUs;
    long lifetimeUs =
        cluster.isVisible()
            ? settings.lifetimeUs()
            : Math.min(settings.lifetimeUs(), UNSEEN_LIFETIME_US);
    return timeUs > cluster.keptUntilUs && (silentUs > lifetimeUs || weakUs > lifetimeUs);
  }

  /**
   * Measures the noise wherever there is no cluster, and within clusters that are so thin that they
   * may be noise themselves.
   */
  void measureNoise(Clusters clusters) {
    double thinEvents = 0;
    double densePixels = 0;
    for (int i = 0; i < clusters.count; i++) {
      Cluster cluster = clusters.all[i];
      double pixels = Math.PI * cluster.extentX * cluster.extentY;
      if (cluster.mass < THIN * places.noiseOf(pixels)) {
        thinEvents += cluster.fresh;
      } else {
        densePixels += pixels;
      }
    }
    places.upkeep(thinEvents, densePixels);
  }

  /** Share of a cluster's events that are noise. */
  double noiseShare(Cluster cluster) {
    if (!places.knowNoise()) {
      return 0;
    }
    double noise = places.noiseOf(Math.PI * cluster.extentX * cluster.extentY);
    return Math.min(MOST_NOISE, noise / Math.max(1, cluster.mass));
  }

  private static double moreThan(double noise, double contrast, double sigmas) {
    return Math.max(contrast * noise, noise + sigmas * Math.sqrt(noise));
  }

  private double noise(Cluster cluster) {
    return places.noiseOf(Math.PI * cluster.radiusA * cluster.radiusB);
  }

  private boolean isOutside(Cluster cluster) {
    if (settings.border() == Border.NEVER) {
      return false;
    }
    boolean outline = settings.border() == Border.OUTLINE;
    double reachX = outline ? cluster.reach(1, 0) : 0;
    double reachY = outline ? cluster.reach(0, 1) : 0;
    return cluster.x - reachX < -0.5
        || cluster.y - reachY < -0.5
        || cluster.x + reachX > right
        || cluster.y + reachY > top;
  }

  /** Whether a cluster is to become visible, among those that there are. */
  boolean isToBeSeen(Cluster cluster, Clusters clusters, long timeUs) {
    if (timeUs < cluster.unseenUntilUs && isBeside(cluster, STILL_BESIDE, clusters)) {
      return false;
    }
    double pixels = Math.PI * cluster.radiusA * cluster.radiusB;
    double noise = places.noiseOf(pixels);
    if (cluster.mass < moreThan(noise, SEEN_CONTRAST, SEEN_SIGMAS)) {
      return false;
    }
    if (isTooSlow(cluster)) {
      return false;
    }
    return settings.visibleBy() == Visibility.MASS
        ? cluster.mass >= settings.visibleMass()
        : cluster.rateHz >= settings.visibleRateHz() * pixels;
  }

  /** Whether it is slower than asked for, or may be for all that is known of its velocity yet. */
  private boolean isTooSlow(Cluster cluster) {
    double least = settings.leastSpeedPxPerS();
    double surely = least + SURE_SPEED_SIGMAS * Math.sqrt(cluster.velocityVariance);
    return least > 0 && cluster.vx * cluster.vx + cluster.vy * cluster.vy < surely * surely;
  }

  /** The invisible cluster with the fewest recent events, or null: it gives way to a newborn. */
  Cluster weakest(Clusters clusters) {
    Cluster weakest = null;
    for (int i = 0; i < clusters.count; i++) {
      Cluster cluster = clusters.all[i];
      cluster.addUp();
      if (!cluster.isVisible()
          && cluster.mass < places.bornEvents()
          && (weakest == null || cluster.mass < weakest.mass)) {
        weakest = cluster;
      }
    }
    return weakest;
  }
}
