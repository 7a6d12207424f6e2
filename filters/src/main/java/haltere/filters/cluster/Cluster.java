package haltere.filters.cluster;

/**
 * The state of one cluster, a struct that the tracker's parts work on, and what an event does to
 * it. Made once, used again.
 *
 * <p>The centre is a line in time: (x, y) at {@link #atUs}, moving with (vx, vy). An event at z of
 * polarity s (1 for ON, -1 for OFF) is expected at the centre plus s times the lead, for the edges
 * in front and behind have different polarities. What is left, e = z - s lead - centre, moves the
 * centre by a e and the velocity by b e; the gains a and b are {@link ClusterMotion}'s.
 */
final class Cluster {
  /** Place in the tracker's store, the same for as long as the tracker lives. */
  final int slot;

  final ClusterPath path = new ClusterPath();
  final ClusterContour contour = new ClusterContour();
  final GapProbe probe = new GapProbe();

  /** Identity, 0 until the cluster is visible. */
  int id;

  long bornUs;

  /** Events taken since birth. */
  long events;

  /** Time of the last event taken, microseconds. */
  long lastUs;

  /** Events taken for itself alone that have yet to be added up. */
  int taken;

  // Motion.

  /** Centre at {@link #atUs}, pixels. */
  double x;

  double y;

  /** Velocity, pixels a second. */
  double vx;

  double vy;

  /** Time of the centre, microseconds. */
  long atUs;

  /** 1e-6 where the centre moves with the velocity between events, else 0. */
  double carry;

  /** Share a of what is left that the centre moves by. */
  double gain;

  /** What is left times this is added to the velocity, 1/s. */
  double velocityGain;

  /** How long a stretch of events the line is fitted to, seconds. */
  double memoryS;

  /** Sum of the weights of the events so far, where weights fall with the time. */
  double weights;

  /** Whether the gains follow from {@link #weights}. */
  boolean gainByWeights;

  /** Velocity gain over gain, 1/s. */
  double velocityShare;

  /** What is left, averaged: about 0 as long as the line fits. */
  double driftX;

  double driftY;

  double driftGain;

  /** Variance of the velocity, per axis, (pixels a second) squared. */
  double velocityVariance;

  /** Centre at the last upkeep. */
  double heldX;

  double heldY;

  /** Direction of the line on which its events are and that goes on beyond it, or 0. */
  double lineX;

  double lineY;

  // Form.

  /** Mean offset of ON events from the centre; OFF events have the opposite one. */
  double leadX;

  double leadY;

  double leadGain;

  /** Covariance of what is left, pixels squared. */
  double cxx;

  double cxy;

  double cyy;

  double formGain;

  /** Means of the square, the cube and the fourth power of what is left along (cos, sin). */
  double square;

  double cube;

  double fourth;

  /** The mean square that there has been for a while. */
  double usualSquare;

  /** Share of ON events less that of OFF events, -1 to 1. */
  double balance;

  /** Inverse of that covariance, and one over the root of its determinant. */
  double ixx;

  double ixy;

  double iyy;

  double density;

  /** Half axis at the direction (cos, sin), and the other, pixels. */
  double radiusA;

  double radiusB;

  /** Geometric mean of the half axes, pixels. */
  double radius;

  double cos;

  double sin;

  /** The matrix that makes the region whose events are taken the unit circle, or box. */
  double m11;

  double m12;

  double m21;

  double m22;

  /** Half width and height of that region, pixels. */
  double extentX;

  double extentY;

  /** Squared radius beyond which that region is surround, 1 where there is none. */
  double surroundFrom;

  // Support.

  /** Events taken, each counting less the longer ago it was. */
  double mass;

  /** The mass that it has had for a while. */
  double usualMass;

  /** Events a second. */
  double rateHz;

  /** Events taken since the last upkeep. */
  double fresh;

  /** When there was last more than noise. */
  long supportedUs;

  long keptUntilUs;

  /** Before this it is not seen beside another one: it may turn out to be a part of that. */
  long unseenUntilUs;

  boolean overlapped;

  // The measurement since the last reading.

  double batchEvents;
  double batchContested;
  double batchX;
  double batchY;

  /** Sums of the times since {@link #batchFromUs}, microseconds, of its own and shared events. */
  private long batchOwnTimes;

  private double batchSharedTimes;

  long batchFromUs;

  /** Mean time of its events, once it has ended, microseconds after it has begun. */
  double batchMeanUs;

  /** Events until one of them is for the outline. */
  int untilOutline;

  /** The same for the probe, and for either of them. */
  private int untilProbe;

  private int untilSample;
  private int sampleStep;

  /** Centre where the index knows it, and how far it may go from there, pixels. */
  double indexX;

  double indexY;
  double indexSlack;

  /** How far from there its cells are known, pixels. */
  double indexReachX;

  double indexReachY;

  Cluster(int slot) {
    this.slot = slot;
  }

  boolean isVisible() {
    return id > 0;
  }

  /** Time since that of the centre, microseconds: no longer than between two upkeeps. */
  private int elapsedUs(long timeUs) {
    return (int) (timeUs - atUs);
  }

  /** Squared distance of a place from the centre, 1 at the outline of what is taken. */
  double distance(double placeX, double placeY, long timeUs, boolean box) {
    int elapsedUs = elapsedUs(timeUs);
    return distance(
        placeX - (x + carry * vx * elapsedUs), placeY - (y + carry * vy * elapsedUs), box);
  }

  /** The same of an offset from the centre. */
  double distance(double dx, double dy, boolean box) {
    double u = m11 * dx + m12 * dy;
    double w = m21 * dx + m22 * dy;
    u *= u;
    w *= w;
    return box ? Math.max(u, w) : u + w;
  }

  /**
   * How likely an event is here rather than elsewhere, but for a factor that all clusters share: a
   * Student distribution with four degrees of freedom, because things have no Gaussian form.
   */
  double likelihood(int eventX, int eventY, int sign, long timeUs) {
    int elapsedUs = elapsedUs(timeUs);
    double dx = eventX - sign * leadX - x - carry * vx * elapsedUs;
    double dy = eventY - sign * leadY - y - carry * vy * elapsedUs;
    double tail = 1 + 0.25 * (dx * (ixx * dx + 2 * ixy * dy) + iyy * dy * dy);
    return density / (tail * tail * tail);
  }

  /** Takes an event that is nobody else's. */
  void take(int eventX, int eventY, int sign, long timeUs) {
    int elapsedUs = elapsedUs(timeUs);
    double px = x + carry * vx * elapsedUs;
    double py = y + carry * vy * elapsedUs;
    double ownX = eventX - sign * leadX;
    double ownY = eventY - sign * leadY;
    double ex = ownX - px;
    double ey = ownY - py;
    if (gainByWeights) {
      weights++;
      gain = 1 / weights;
      velocityGain = gain * velocityShare;
    }
    x = px + gain * ex;
    y = py + gain * ey;
    vx += velocityGain * ex;
    vy += velocityGain * ey;
    atUs = timeUs;
    taken++;
    batchX += ownX;
    batchY += ownY;
    batchOwnTimes += timeUs - batchFromUs;
    learn(ex, ey, sign);
    if (--untilSample <= 0) {
      sample(eventX, eventY, sign, px, py, 1);
    }
  }

  /** Adds up the events that it has taken for itself alone. */
  void addUp() {
    if (taken > 0) {
      lastUs = Math.max(lastUs, atUs);
      mass += taken;
      fresh += taken;
      events += taken;
      batchEvents += taken;
      taken = 0;
    }
  }

  /** Gives an event to those that look at some of them. */
  private void sample(double eventX, double eventY, int sign, double px, double py, double weight) {
    untilOutline -= sampleStep;
    untilProbe -= sampleStep;
    if (untilOutline <= 0) {
      contour.take(this, eventX, eventY, px, py, weight);
    }
    if (untilProbe <= 0) {
      untilProbe = probe.take(eventX, eventY, sign);
    }
    sampleStep = Math.min(untilOutline, untilProbe);
    untilSample = sampleStep;
  }

  /** The next event is for those that look at some of them. */
  void sampleSoon() {
    untilOutline = 1;
    untilProbe = 1;
    sampleStep = 1;
    untilSample = 1;
  }

  /** Counts an event that does not move it. */
  void count(long timeUs) {
    lastUs = timeUs;
    mass++;
    fresh++;
    events++;
  }

  /** Learns from what is left of an event how the events lie about the centre. */
  private void learn(double ex, double ey, int sign) {
    driftX += driftGain * (ex - driftX);
    driftY += driftGain * (ey - driftY);
    double lean = leadGain * sign;
    leadX += lean * ex;
    leadY += lean * ey;
    double share = formGain;
    cxx += share * (ex * ex - cxx);
    cxy += share * (ex * ey - cxy);
    cyy += share * (ey * ey - cyy);
    balance += share * (sign - balance);
    double along = ex * cos + ey * sin;
    double alongSquared = along * along;
    square += share * (alongSquared - square);
    cube += share * (alongSquared * along - cube);
    fourth += share * (alongSquared * alongSquared - fourth);
  }

  /**
   * Takes a share of an event that may be another's as well: it moves the cluster by as much less,
   * and says nothing about its form.
   */
  void take(int eventX, int eventY, int sign, long timeUs, double share) {
    double ownX = eventX - sign * leadX;
    double ownY = eventY - sign * leadY;
    int elapsedUs = elapsedUs(timeUs);
    double px = x + carry * vx * elapsedUs;
    double py = y + carry * vy * elapsedUs;
    double ex = ownX - px;
    double ey = ownY - py;
    if (gainByWeights) {
      weights += share;
      gain = 1 / Math.max(1, weights);
      velocityGain = gain * velocityShare;
    }
    x = px + share * gain * ex;
    y = py + share * gain * ey;
    vx += share * velocityGain * ex;
    vy += share * velocityGain * ey;
    atUs = timeUs;
    lastUs = timeUs;
    mass += share;
    fresh += share;
    events++;
    batchEvents += share;
    batchContested += share;
    batchX += share * ownX;
    batchY += share * ownY;
    batchSharedTimes += share * (timeUs - batchFromUs);
    if (--untilSample <= 0) {
      sample(eventX, eventY, sign, px, py, share);
    }
  }

  /** Moves the centre on to a time, and adds up what it has taken. */
  void moveTo(long timeUs) {
    addUp();
    double dt = (timeUs - atUs) * carry;
    x += vx * dt;
    y += vy * dt;
    atUs = timeUs;
  }

  /** Goes on where a part of it is that was to be a cluster of its own. */
  void takePlaceOf(Cluster part) {
    x = part.x;
    y = part.y;
    mass = part.mass;
    usualMass = part.usualMass;
  }

  /** Whether the centre has left the place that the index knows. */
  boolean hasLeftIndex() {
    return Math.abs(x - indexX) + Math.abs(y - indexY) > indexSlack;
  }

  void clearBatch(long timeUs) {
    batchEvents = 0;
    batchContested = 0;
    batchX = 0;
    batchY = 0;
    batchOwnTimes = 0;
    batchSharedTimes = 0;
    batchFromUs = timeUs;
  }

  /** Works out the mean time of the events of the measurement, which ends now. */
  void endBatch() {
    batchMeanUs = (batchOwnTimes + batchSharedTimes) / batchEvents;
  }

  /** Variance of the events of one polarity in the direction in which it is the least. */
  double leastVariance() {
    double half = 0.5 * (cxx - cyy);
    return 0.5 * (cxx + cyy) - Math.sqrt(half * half + cxy * cxy);
  }

  /** Takes on half axes, pixels. */
  void setRadii(double along, double across) {
    radiusA = along;
    radiusB = across;
    radius = Math.sqrt(along * across);
  }

  /** Distance of the outline from the centre in a direction, a vector of any length but 0. */
  double reach(double directionX, double directionY) {
    double u = (cos * directionX + sin * directionY) / radiusA;
    double w = (cos * directionY - sin * directionX) / radiusB;
    return Math.sqrt((directionX * directionX + directionY * directionY) / (u * u + w * w));
  }
}
