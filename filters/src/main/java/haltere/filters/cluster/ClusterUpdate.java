package haltere.filters.cluster;

import haltere.core.event.SensorGeometry;
import haltere.filters.cluster.ClusterLifeSettings.Border;
import haltere.filters.cluster.ClusterLifeSettings.Support;
import haltere.filters.cluster.ClusterMotionSettings.StartVelocity;
import haltere.filters.cluster.ClusterMotionSettings.Weight;

/**
 * Update of single clusters: motion, mass, support and death. Rates are unbiased: at a constant
 * rate of events λ the mass tends to λ τ. Thread rule: immutable.
 */
final class ClusterUpdate {
  private static final double US = 1e-6;

  private final ClusterLifeSettings life;
  private final ClusterMotionSettings motion;
  private final ClusterShape shape;
  private final int intervalUs;
  private final double massDecay;
  private final double right;
  private final double top;

  ClusterUpdate(SensorGeometry geometry, ClusterTrackerSettings settings, ClusterShape shape) {
    this.shape = shape;
    life = settings.life();
    motion = settings.motion();
    intervalUs = settings.output().updateIntervalUs();
    massDecay = decay(intervalUs, life.massTimeUs());
    right = geometry.width() - 0.5;
    top = geometry.height() - 0.5;
  }

  private static double decay(long elapsedUs, int timeConstantUs) {
    return StrictMath.exp(-(double) elapsedUs / timeConstantUs);
  }

  /** Initialises a cluster with one event. */
  void start(Cluster born, Cluster[] others, int count, long timeUs) {
    born.id = 0;
    born.visible = false;
    born.bornUs = timeUs;
    born.updatedUs = timeUs;
    born.supportedUs = timeUs;
    born.events = 0;
    born.fresh = 1;
    born.inhibited = 0;
    born.mass = 0;
    born.rateHz = 0;
    born.joinedScale = 1;
    born.vx = 0;
    born.vy = 0;
    born.weights = Double.NaN;
    if (motion.startVelocity() == StartVelocity.MEAN) {
      int visible = 0;
      for (int i = 0; i < count; i++) {
        if (others[i].visible) {
          visible++;
          born.vx += (others[i].vx - born.vx) / visible;
          born.vy += (others[i].vy - born.vy) / visible;
        }
      }
    }
  }

  /** Sets the gains of a cluster. */
  void setGains(Cluster cluster) {
    cluster.velocityShare = 1 / (US * motion.velocityTimeUs());
    if (motion.weight() == Weight.PER_TIME) {
      cluster.weights = Double.isNaN(cluster.weights) ? 1 : cluster.weights;
      return;
    }
    cluster.weights = Double.NaN;
    cluster.gain = motion.mixingFactor();
    if (motion.weight() == Weight.PER_EVENT_AND_RATE) {
      double pixelRateHz = pixelRateHz(cluster);
      cluster.gain *= Math.min(1, life.visibleRateHz() / Math.max(pixelRateHz, Double.MIN_NORMAL));
    }
  }

  /** Mean event rate of a pixel of the cluster. */
  private static double pixelRateHz(Cluster cluster) {
    return cluster.rateHz / (4 * cluster.radiusAlong * cluster.radiusAcross);
  }

  /** Advances a cluster to the time of an update. */
  void update(Cluster cluster, long timeUs) {
    long elapsedUs = timeUs - cluster.updatedUs;
    cluster.updatedUs = timeUs;
    if (elapsedUs > 0) {
      move(cluster, elapsedUs);
      double factor = elapsedUs == intervalUs ? massDecay : decay(elapsedUs, life.massTimeUs());
      // mean decay of events spread evenly over the interval
      double fresh =
          (cluster.fresh - cluster.inhibited) * (1 - factor) * life.massTimeUs() / elapsedUs;
      cluster.mass = Math.max(0, cluster.mass * factor + fresh);
    }
    cluster.events += cluster.fresh;
    cluster.fresh = 0;
    cluster.inhibited = 0;
    cluster.rateHz = cluster.mass / (US * life.massTimeUs());
    setGains(cluster);
    shape.adapt(cluster);
    boolean supported =
        life.supportedBy() == Support.MASS
            ? cluster.mass >= life.visibleMass()
            : pixelRateHz(cluster) >= life.visibleRateHz();
    if (supported) {
      cluster.supportedUs = timeUs;
    }
    cluster.visible = supported && cluster.speed() >= life.minSpeedPxS();
  }

  private void move(Cluster cluster, long elapsedUs) {
    if (motion.predict()) {
      cluster.x += US * elapsedUs * cluster.vx;
      cluster.y += US * elapsedUs * cluster.vy;
    }
    double factor = motion.predict() ? 1 : decay(elapsedUs, motion.velocityTimeUs());
    if (motion.frictionTimeUs() > 0) {
      factor *= decay(elapsedUs, motion.frictionTimeUs());
    }
    cluster.vx *= factor;
    cluster.vy *= factor;
    if (motion.weight() == Weight.PER_TIME) {
      cluster.weights *= decay(elapsedUs, motion.mixingTimeUs());
    }
  }

  /** Limits each speed to that of the fastest visible neighbour. */
  void limitSpeeds(Cluster[] clusters, int count) {
    for (int i = 0; motion.neighbourRadii() > 0 && i < count; i++) {
      Cluster cluster = clusters[i];
      double fastest = -1;
      for (int j = 0; j < count; j++) {
        Cluster other = clusters[j];
        double reach = motion.neighbourRadii() * (cluster.radius() + other.radius());
        double distance = Math.hypot(other.x - cluster.x, other.y - cluster.y);
        if (j != i && other.visible && distance < reach) {
          fastest = Math.max(fastest, other.speed());
        }
      }
      double speed = cluster.speed();
      if (fastest >= 0 && speed > fastest) {
        cluster.vx *= fastest / speed;
        cluster.vy *= fastest / speed;
      }
    }
  }

  /** Whether a cluster has lost support for too long, or has left the sensor. */
  boolean isDead(Cluster cluster, long timeUs) {
    if (timeUs - cluster.supportedUs > life.lifetimeUs()) {
      return true;
    }
    if (life.border() == Border.NEVER) {
      return false;
    }
    boolean touching = life.border() == Border.OUTLINE;
    double marginX = touching ? cluster.extentX / shape.surround() : 0;
    double marginY = touching ? cluster.extentY / shape.surround() : 0;
    return cluster.x - marginX < -0.5
        || cluster.y - marginY < -0.5
        || cluster.x + marginX > right
        || cluster.y + marginY > top;
  }
}
