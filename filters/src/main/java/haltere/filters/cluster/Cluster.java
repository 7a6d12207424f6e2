package haltere.filters.cluster;

/**
 * The present state of one cluster of a {@link ClusterTracker}. The tracker reuses the object for
 * another cluster, with another {@link #id}.
 *
 * <p>Thread rule: that of its tracker.
 */
public final class Cluster {
  /** Identity, 0 until the cluster is visible for the first time. */
  int id;

  long bornUs;

  /** Time of the last update, microseconds. */
  long updatedUs;

  /** When the cluster had support last, microseconds. */
  long supportedUs;

  boolean visible;

  /** Events since birth, without {@link #fresh}. */
  long events;

  /** Events since the last update. */
  int fresh;

  /** Mass removed by events in the surround since the last update. */
  double inhibited;

  /** Mass at the last update. */
  double mass;

  /** Events a second, averaged with the time constant of the mass. */
  double rateHz;

  // Motion.

  double x;
  double y;

  /** Velocity, pixels a second. */
  double vx;

  double vy;

  /** Share of the distance to an event that the cluster moves by. */
  double gain;

  /** Ratio of velocity gain to location gain, 1/s. */
  double velocityShare;

  /** Sum of the weights of the events, where the gain is their inverse; else NaN. */
  double weights;

  // Shape.

  /** Second moments of the events about the location, pixels squared. */
  double momentXx;

  double momentXy;

  double momentYy;

  /** Half axis at the angle (cos, sin), and across it, pixels. */
  double radiusAlong;

  double radiusAcross;

  double cos;
  double sin;

  /** Factor of the a-priori size due to mergers. */
  double joinedScale;

  /** The matrix that maps the capture region to the unit circle, or box. */
  double m11;

  double m12;

  double m21;

  double m22;

  /** Half width and half height of the capture region, pixels. */
  double extentX;

  double extentY;

  /** Location in the index, pixels. */
  double indexX;

  double indexY;

  Cluster() {}

  /** {@return the identity, from 1, never reused; 0 before the cluster was visible} */
  public int id() {
    return id;
  }

  /** {@return whether it is reported: true while it has an identity and support} */
  public boolean isVisible() {
    return visible;
  }

  /** {@return column of the centre, pixels} */
  public double xPx() {
    return x;
  }

  /** {@return row of the centre, pixels} */
  public double yPx() {
    return y;
  }

  /** {@return events since its birth, at least 1} */
  public long eventCount() {
    return events + fresh;
  }

  /** Squared distance of an offset from the centre; 1 at the end of the capture region. */
  double distance(double dx, double dy, boolean box) {
    double along = m11 * dx + m12 * dy;
    double across = m21 * dx + m22 * dy;
    along *= along;
    across *= across;
    return box ? Math.max(along, across) : along + across;
  }

  /** Moves towards an event: x ← (1 − m) x + m z, and updates the velocity by the motion over τ. */
  void take(double dx, double dy) {
    fresh++;
    if (weights >= 0) {
      weights++;
      gain = 1 / weights;
    }
    double moveX = gain * dx;
    double moveY = gain * dy;
    x += moveX;
    y += moveY;
    vx += velocityShare * moveX;
    vy += velocityShare * moveY;
  }

  /** Updates the second moments with an event. */
  void adaptShape(double dx, double dy) {
    momentXx += gain * (dx * dx - momentXx);
    momentXy += gain * (dx * dy - momentXy);
    momentYy += gain * (dy * dy - momentYy);
  }

  /** Geometric mean of the half axes, pixels. */
  double radius() {
    return Math.sqrt(radiusAlong * radiusAcross);
  }

  double speed() {
    return Math.sqrt(vx * vx + vy * vy);
  }

  /** Its state at a time as a result, predicted by its velocity over a time step. */
  ClusterTrack track(long timeUs, double predictedS) {
    return new ClusterTrack(
        timeUs,
        id,
        x + vx * predictedS,
        y + vy * predictedS,
        vx,
        vy,
        radius(),
        radiusAlong / radiusAcross,
        cos == 0 ? Math.PI / 2 : Math.atan(sin / cos),
        eventCount(),
        Math.max(0, mass + fresh - inhibited),
        rateHz,
        timeUs - bornUs);
  }
}
