package haltere.filters.cluster;

import haltere.core.event.SensorGeometry;
import haltere.filters.cluster.ClusterFormSettings.Angle;
import haltere.filters.cluster.ClusterFormSettings.Outline;

/**
 * Size, aspect and angle of clusters.
 *
 * <p>The spread of a cluster's events is the covariance of what is left around the expected places
 * of the two polarities, plus the outer product of the lead, the covariance of these places. The
 * half axes are {@link #RADII} standard deviations: a disc of which only the edge makes events then
 * just fits. That times the default surround is below 2, so a region full of evenly spread noise
 * shrinks rather than grows, and one that ends within a thing grows until it contains it.
 */
final class ClusterForm {
  /** Half axis over standard deviation. */
  static final double RADII = 1.7;

  /** The smallest variance, of the pixel itself and what it blurs, pixels squared. */
  private static final double LEAST_VARIANCE = 0.15;

  private static final double LEAST_RADIUS = 1.5;
  private static final double GREATEST_ASPECT = 5;

  /** A settled cluster grows by no more than the factor e in this time. */
  private static final double GROWTH_TIME_US = 250_000;

  /** The same for a young one. */
  private static final double YOUNG_GROWTH_TIME_US = 40_000;

  /** A memory has at least so many times as many events as the outline has pixels, */
  private static final double OUTLINES = 2;

  /** and of the pixels within at least this share. */
  private static final double PIXELS_SHARE = 0.25;

  private static final double MOST_MEMORY = 10_000;

  /** A radius is usual after about this time. */
  private static final double USUAL_TIME_US = 1_000_000;

  /** By what factor either way the mean square has changed where two things part or near. */
  private static final double PARTING = 1.2;

  /** The same where other clusters overlap, whose events make it larger as well. */
  private static final double OVERLAPPED_PARTING = 6;

  /**
   * Kurtosis less the square of the skewness below which events are at two places: 1 for two
   * points, whatever their weights, 1.8 for an even spread, 3 for a Gaussian one.
   */
  private static final double TWO_PLACES = 1.5;

  /** Square of the mean of what is left, over the mean square, up to which a centre fits. */
  private static final double GREATEST_DRIFT = 0.1;

  /** Balance from which on a cluster has one polarity only. */
  private static final double ONE_SIDED = 0.95;

  /** Share of the lead that then fades with each upkeep. */
  private static final double LEAD_FADING = 0.01;

  /** Share of the spread along the two places that is the distance between them. */
  static final double WITHIN = 0.85;

  /** Share of the spread in one direction, given that in the other, that may be between parts. */
  private static final double MOST_BETWEEN = 0.97;

  /** A younger cluster finds its size first. */
  static final long SETTLED_US = 80_000;

  private final ClusterFormSettings form;
  private final ClusterGrowthSettings growth;
  private final PerspectiveSettings perspective;
  private final boolean edges;
  private final double startRadius;
  private final double vanishingX;
  private final double vanishingY;
  private final double scalePerPixel;
  private final double growthFactor;
  private final double youngGrowthFactor;
  private final double usualGain;
  private final double surround;
  private final double fixedCos;
  private final double fixedSin;

  ClusterForm(SensorGeometry geometry, ClusterTrackerSettings all) {
    form = all.form();
    growth = all.growth();
    perspective = all.perspective();
    edges = all.events().edges();
    startRadius = Math.max(LEAST_RADIUS, form.size() * geometry.longerSide());
    vanishingX = perspective.vanishingX() * (geometry.width() - 1);
    vanishingY = perspective.vanishingY() * (geometry.height() - 1);
    scalePerPixel = 1.0 / geometry.longerSide();
    growthFactor = StrictMath.exp(all.output().upkeepUs() / GROWTH_TIME_US);
    youngGrowthFactor = StrictMath.exp(all.output().upkeepUs() / YOUNG_GROWTH_TIME_US);
    usualGain = 1 - StrictMath.exp(-all.output().upkeepUs() / USUAL_TIME_US);
    surround = surround(all);
    fixedCos = StrictMath.cos(StrictMath.toRadians(form.angleDeg()));
    fixedSin = StrictMath.sin(StrictMath.toRadians(form.angleDeg()));
  }

  /** How much larger than a cluster the region is whose events it takes. */
  static double surround(ClusterTrackerSettings all) {
    return all.growth().size() || all.events().inhibition() > 0 ? all.growth().surround() : 1;
  }

  boolean isBox() {
    return form.outline() == Outline.BOX;
  }

  /** Whether the size of clusters follows their events. */
  boolean isSizeFree() {
    return growth.size();
  }

  /** Radius that a cluster begins with, pixels. */
  double startRadius() {
    return startRadius;
  }

  /** Begins with the a-priori form, at the cluster's place. */
  void begin(Cluster cluster) {
    double radius = startRadius * scale(cluster.x, cluster.y);
    double variance = radius * radius / (RADII * RADII);
    cluster.cxx = variance;
    cluster.cxy = 0;
    cluster.cyy = variance;
    cluster.leadX = 0;
    cluster.leadY = 0;
    cluster.balance = 0;
    cluster.setRadii(radius, radius);
    cluster.cos = fixedCos;
    cluster.sin = fixedSin;
    invert(cluster);
    setSpread(cluster, variance);
    cluster.usualSquare = variance;
    upkeep(cluster, cluster.bornUs, 0);
  }

  /**
   * Works out the region from the spread.
   *
   * @param noise share of the cluster's events that are noise, evenly spread over its region
   */
  void upkeep(Cluster cluster, long timeUs, double noise) {
    double settled = Math.min(memory(cluster, timeUs), cluster.events + 8.0);
    cluster.formGain = 1 / settled;
    boolean oneSided = Math.abs(cluster.balance) > ONE_SIDED;
    cluster.leadGain = edges && !oneSided ? 1 / settled : 0;
    if (!edges) {
      cluster.leadX = 0;
      cluster.leadY = 0;
    }
    if (oneSided) {
      forgetLead(cluster);
    }
    invert(cluster);
    double sxx = cluster.cxx + cluster.leadX * cluster.leadX + LEAST_VARIANCE;
    double sxy = cluster.cxy + cluster.leadX * cluster.leadY;
    double syy = cluster.cyy + cluster.leadY * cluster.leadY + LEAST_VARIANCE;
    turn(cluster, sxx, sxy, syy);
    double c = cluster.cos;
    double s = cluster.sin;
    double along = c * c * sxx + 2 * c * s * sxy + s * s * syy;
    double across = s * s * sxx - 2 * c * s * sxy + c * c * syy;
    if (noise > 0) {
      along = withoutNoise(along, cluster.radiusA, noise);
      across = withoutNoise(across, cluster.radiusB, noise);
    }
    along = RADII * Math.sqrt(Math.max(0, along));
    across = RADII * Math.sqrt(Math.max(0, across));
    setRadii(cluster, along, across, timeUs);
    setRegion(cluster);
    cluster.usualSquare +=
        (timeUs - cluster.bornUs <= SETTLED_US ? 1 : usualGain)
            * (cluster.square - cluster.usualSquare);
  }

  /**
   * Over how many events the spread is averaged: as many as is set, but so many that all of a thing
   * has spoken. The pixels along a straight edge fire together, and where a thing is large, its
   * next edge only hundreds of events later. A young cluster finds its size first.
   */
  private double memory(Cluster cluster, long timeUs) {
    if (timeUs - cluster.bornUs <= SETTLED_US) {
      return growth.events();
    }
    double radius = Math.min(MOST_MEMORY, Math.max(cluster.radiusA, cluster.radiusB));
    double outlines = OUTLINES * 2 * Math.PI * radius;
    double pixels = PIXELS_SHARE * Math.PI * radius * radius;
    return Math.max(growth.events(), Math.min(MOST_MEMORY, Math.max(outlines, pixels)));
  }

  /**
   * Where there is one polarity only, how far its events are from the centre is known if they are a
   * part of a round outline. Otherwise the lead fades, and the centre goes to where the events are.
   */
  private static void forgetLead(Cluster cluster) {
    if (cluster.contour.isPlaced()) {
      cluster.contour.centre(cluster, cluster.balance > 0 ? 1 : -1);
      return;
    }
    double side = cluster.balance > 0 ? LEAD_FADING : -LEAD_FADING;
    cluster.x += side * cluster.leadX;
    cluster.y += side * cluster.leadY;
    cluster.leadX -= LEAD_FADING * cluster.leadX;
    cluster.leadY -= LEAD_FADING * cluster.leadY;
  }

  /** Takes from a variance what evenly spread noise adds: a quarter of the squared half axis. */
  private double withoutNoise(double variance, double radius, double noise) {
    double reach = radius * surround;
    return (variance - noise * 0.25 * reach * reach) / (1 - noise);
  }

  /**
   * Whether a cluster is not what it was because its events are at two places that part or near:
   * two things that were taken for one. Two places that stay as they are may be one thing's.
   */
  boolean isParting(Cluster cluster, long timeUs) {
    return growth.size()
        && timeUs - cluster.bornUs > SETTLED_US
        && isOtherThanUsual(cluster)
        && twoPlaces(cluster) < TWO_PLACES
        && fits(cluster);
  }

  private static boolean isOtherThanUsual(Cluster cluster) {
    if (cluster.overlapped) {
      return cluster.square > OVERLAPPED_PARTING * cluster.usualSquare;
    }
    return cluster.square > PARTING * cluster.usualSquare
        || cluster.square * PARTING < cluster.usualSquare;
  }

  /** Whether events are about the centre now: one that lags has been at two places as well. */
  private static boolean fits(Cluster cluster) {
    double along = cluster.driftX * cluster.cos + cluster.driftY * cluster.sin;
    return along * along < GREATEST_DRIFT * cluster.square;
  }

  private static double twoPlaces(Cluster cluster) {
    double square = cluster.square;
    double skewness = cluster.cube * cluster.cube / (square * square * square);
    return cluster.fourth / (square * square) - skewness;
  }

  /** Gives both parts of a cluster what is left of its spread once that between them is gone. */
  void part(Cluster cluster, Cluster born, long timeUs) {
    double between = Math.min(cluster.square * WITHIN, greatestBetween(cluster));
    double c = cluster.cos;
    double s = cluster.sin;
    cluster.cxx -= between * c * c;
    cluster.cxy -= between * c * s;
    cluster.cyy -= between * s * s;
    setSpread(cluster, cluster.square - between);
    born.cxx = cluster.cxx;
    born.cxy = cluster.cxy;
    born.cyy = cluster.cyy;
    setSpread(born, cluster.square);
    born.leadX = cluster.leadX;
    born.leadY = cluster.leadY;
    born.balance = cluster.balance;
    born.cos = c;
    born.sin = s;
    born.setRadii(cluster.radiusA, cluster.radiusB);
    upkeep(cluster, timeUs, 0);
    upkeep(born, timeUs, 0);
    cluster.usualSquare = cluster.square;
    born.usualSquare = born.square;
  }

  /** What may be taken along the first half axis so that what is left is a covariance. */
  private static double greatestBetween(Cluster cluster) {
    double c = cluster.cos;
    double s = cluster.sin;
    return MOST_BETWEEN / (c * c * cluster.ixx + 2 * c * s * cluster.ixy + s * s * cluster.iyy);
  }

  /** Takes what is left along the first half axis as Gaussian, as long as nothing else is known. */
  private static void setSpread(Cluster cluster, double variance) {
    cluster.square = variance;
    cluster.cube = 0;
    cluster.fourth = 3 * variance * variance;
  }

  /** Takes a form that has changed at once as the usual one. */
  void settle(Cluster cluster, long timeUs) {
    cluster.contour.end();
    setSpread(
        cluster,
        cluster.cxx * cluster.cos * cluster.cos
            + 2 * cluster.cxy * cluster.cos * cluster.sin
            + cluster.cyy * cluster.sin * cluster.sin);
    cluster.setRadii(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
    upkeep(cluster, timeUs, 0);
    cluster.usualSquare = cluster.square;
  }

  private void setRadii(Cluster cluster, double along, double across, long timeUs) {
    double a = along;
    double b = across;
    double scaled = startRadius * scale(cluster.x, cluster.y);
    if (!growth.aspect()) {
      double larger = Math.max(a, b);
      double root = Math.sqrt(form.aspect());
      a = larger / root;
      b = larger * root;
    } else {
      a = Math.max(a, b / GREATEST_ASPECT);
      b = Math.max(b, a / GREATEST_ASPECT);
    }
    if (growth.size()) {
      double least = Math.max(LEAST_RADIUS, scaled / growth.mostScale());
      double most = Math.max(least, scaled * growth.mostScale());
      double faster = timeUs - cluster.bornUs > SETTLED_US ? growthFactor : youngGrowthFactor;
      a = Math.min(a, cluster.radiusA * faster);
      b = Math.min(b, cluster.radiusB * faster);
      a = Math.min(most, Math.max(least, a));
      b = Math.min(most, Math.max(least, b));
    } else {
      double correction = scaled / Math.sqrt(a * b);
      a *= correction;
      b *= correction;
    }
    cluster.setRadii(a, b);
  }

  /** Chooses the direction of the first half axis. */
  private void turn(Cluster cluster, double sxx, double sxy, double syy) {
    double directionX = cluster.cos;
    double directionY = cluster.sin;
    if (form.angle() == Angle.OF_EVENTS) {
      double half = 0.5 * (sxx - syy);
      double root = Math.sqrt(half * half + sxy * sxy);
      directionX = half >= 0 ? half + root : sxy;
      directionY = half >= 0 ? sxy : root - half;
    } else if (form.angle() == Angle.OF_VELOCITY) {
      directionX = cluster.vx;
      directionY = cluster.vy;
    } else {
      directionX = fixedCos;
      directionY = fixedSin;
    }
    double length = Math.sqrt(directionX * directionX + directionY * directionY);
    if (length > 1e-6) {
      cluster.cos = directionX / length;
      cluster.sin = directionY / length;
    }
  }

  private void setRegion(Cluster cluster) {
    double a = cluster.radiusA * surround;
    double b = cluster.radiusB * surround;
    double c = cluster.cos;
    double s = cluster.sin;
    cluster.m11 = c / a;
    cluster.m12 = s / a;
    cluster.m21 = -s / b;
    cluster.m22 = c / b;
    cluster.surroundFrom = 1 / (surround * surround);
    if (isBox()) {
      cluster.extentX = Math.abs(a * c) + Math.abs(b * s);
      cluster.extentY = Math.abs(a * s) + Math.abs(b * c);
    } else {
      cluster.extentX = Math.sqrt(a * c * a * c + b * s * b * s);
      cluster.extentY = Math.sqrt(a * s * a * s + b * c * b * c);
    }
  }

  private static void invert(Cluster cluster) {
    double cxx = cluster.cxx + LEAST_VARIANCE;
    double cyy = cluster.cyy + LEAST_VARIANCE;
    double determinant = cxx * cyy - cluster.cxy * cluster.cxy;
    cluster.ixx = cyy / determinant;
    cluster.iyy = cxx / determinant;
    cluster.ixy = -cluster.cxy / determinant;
    cluster.density = 1 / Math.sqrt(determinant);
  }

  private double scale(double x, double y) {
    if (!perspective.enabled()) {
      return 1;
    }
    double dx = x - vanishingX;
    double dy = y - vanishingY;
    return Math.max(perspective.leastScale(), scalePerPixel * Math.sqrt(dx * dx + dy * dy));
  }
}
