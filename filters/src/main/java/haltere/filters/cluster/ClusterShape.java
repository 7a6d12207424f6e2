package haltere.filters.cluster;

import haltere.core.event.SensorGeometry;
import haltere.filters.cluster.ClusterShapeSettings.Angle;
import haltere.filters.cluster.ClusterShapeSettings.Type;

/** Size, aspect and angle of clusters. Thread rule: immutable. */
final class ClusterShape {
  /** Largest ratio of the half axes that the events give a cluster, as in Delbruck's trackers. */
  private static final double MAX_ADAPTED_ASPECT = 2.5;

  private final ClusterShapeSettings shape;
  private final ClusterGrowthSettings growth;
  private final PerspectiveSettings perspective;
  private final double longerSide;
  private final double vanishingX;
  private final double vanishingY;

  /** Square of a half side over the variance of events evenly spread: 3 in a box, 4 in a disc. */
  private final double radiiPerDeviation2;

  private final double surround;

  ClusterShape(SensorGeometry geometry, ClusterTrackerSettings settings) {
    shape = settings.shape();
    growth = settings.growth();
    perspective = settings.perspective();
    longerSide = geometry.longerSide();
    vanishingX = perspective.vanishingX() * (geometry.width() - 1);
    vanishingY = perspective.vanishingY() * (geometry.height() - 1);
    radiiPerDeviation2 = shape.type() == Type.BOX ? 3 : 4;
    surround = growth.size() ? growth.surround() : 1;
  }

  /** Ratio of the capture region to the cluster. */
  double surround() {
    return surround;
  }

  /** Whether the second moments of the events are used. */
  boolean isAdaptive() {
    return growth.size() || growth.aspect() || shape.angle() == Angle.OF_EVENTS;
  }

  /** A-priori radius at a position, pixels. */
  private double priorRadius(Cluster cluster) {
    double scale = 1;
    if (perspective.enabled()) {
      double distance = Math.hypot(cluster.x - vanishingX, cluster.y - vanishingY);
      scale = Math.max(perspective.minScale(), distance / longerSide);
    }
    return shape.size() * longerSide * scale;
  }

  /** Gives a newborn cluster the a-priori shape. */
  void start(Cluster born) {
    double radius = priorRadius(born);
    born.momentXx = radius * radius / radiiPerDeviation2;
    born.momentXy = 0;
    born.momentYy = born.momentXx;
    double angle = StrictMath.toRadians(shape.angleDeg());
    born.cos = StrictMath.cos(angle);
    born.sin = StrictMath.sin(angle);
    setRadii(born, radius, 1 / shape.aspect());
  }

  /** Adapts the shape to the second moments and the velocity. */
  void adapt(Cluster cluster) {
    double radius = priorRadius(cluster);
    if (growth.size()) {
      double variance = 0.5 * (cluster.momentXx + cluster.momentYy);
      double spread = Math.sqrt(radiiPerDeviation2 * variance);
      radius = Math.max(radius / growth.maxScale(), Math.min(radius * growth.maxScale(), spread));
    } else if (cluster.joinedScale > 1) {
      radius *= Math.min(growth.maxScale(), cluster.joinedScale);
    }
    turn(cluster);
    setRadii(cluster, radius, growth.aspect() ? adaptedAspect(cluster) : 1 / shape.aspect());
  }

  private void turn(Cluster cluster) {
    double half = 0.5 * (cluster.momentXx - cluster.momentYy);
    if (shape.angle() == Angle.OF_EVENTS && (half != 0 || cluster.momentXy != 0)) {
      double angle = 0.5 * StrictMath.atan2(cluster.momentXy, half);
      cluster.cos = StrictMath.cos(angle);
      cluster.sin = StrictMath.sin(angle);
    } else if (shape.angle() == Angle.OF_VELOCITY && cluster.speed() > 0) {
      cluster.cos = cluster.vx / cluster.speed();
      cluster.sin = cluster.vy / cluster.speed();
    }
  }

  /** Standard deviation along the angle over that across it. */
  private static double adaptedAspect(Cluster cluster) {
    double c = cluster.cos;
    double s = cluster.sin;
    double mixed = 2 * c * s * cluster.momentXy;
    double along = c * c * cluster.momentXx + mixed + s * s * cluster.momentYy;
    double across = s * s * cluster.momentXx - mixed + c * c * cluster.momentYy;
    double aspect = Math.sqrt(Math.max(0, along) / Math.max(Double.MIN_NORMAL, across));
    return Math.max(1 / MAX_ADAPTED_ASPECT, Math.min(MAX_ADAPTED_ASPECT, aspect));
  }

  /** Sets the half axes of a cluster and its capture region; the aspect is along over across. */
  private void setRadii(Cluster cluster, double radius, double aspect) {
    double root = Math.sqrt(aspect);
    cluster.radiusAlong = radius * root;
    cluster.radiusAcross = radius / root;
    double c = cluster.cos;
    double s = cluster.sin;
    double along = surround * cluster.radiusAlong;
    double across = surround * cluster.radiusAcross;
    cluster.m11 = c / along;
    cluster.m12 = s / along;
    cluster.m21 = -s / across;
    cluster.m22 = c / across;
    if (shape.type() == Type.BOX) {
      cluster.extentX = Math.abs(c) * along + Math.abs(s) * across;
      cluster.extentY = Math.abs(s) * along + Math.abs(c) * across;
    } else {
      cluster.extentX = Math.sqrt(c * c * along * along + s * s * across * across);
      cluster.extentY = Math.sqrt(s * s * along * along + c * c * across * across);
    }
  }

  /** Gives a merged cluster the size of both: r = r₁ + r₂. */
  void join(Cluster survivor, Cluster lost) {
    double scale = (survivor.radius() + lost.radius()) / survivor.radius();
    survivor.joinedScale *= scale;
    survivor.momentXx *= scale * scale;
    survivor.momentXy *= scale * scale;
    survivor.momentYy *= scale * scale;
    adapt(survivor);
  }
}
