package haltere.filters.cluster;

/**
 * The round outline of a cluster, fitted to its events: what a cluster knows beyond the mean of its
 * events if they lie on a thin ring or on a part of one.
 *
 * <p>An event at z says of the centre c and the radius R that |z - c| = R + noise. About a
 * reference q near the centre, with n the direction from q to the event, that is
 *
 * <pre>
 *   |z - q| - R₀ = n (c - q) + (R - R₀) + noise,  noise of variance s²,
 * </pre>
 *
 * <p>a line in (c, R): least squares, where each event counts in the direction across the outline
 * only, in which it is known to a third of a pixel. Events at one side of the thing, be it since
 * the border of the sensor cuts it off or since it has just begun to enter, make the fit uncertain
 * and not wrong, as their mean would be. The radius is what the readings before have left it, with
 * a variance. It is given to readers as information, J = I_cc - I_cR I_Rc / (I_RR + s²/P_R), over
 * s².
 *
 * <p>A ring is believed only where it fits better than a straight line would. Events off the ring
 * by more than three standard deviations take no part. Of many events between two readings only
 * some are taken, which bounds the cost. Thread rule: that of its owner.
 */
final class ClusterContour {
  private static final double US = 1e-6;

  /** A ring is thin if its scatter is less than this share of its radius. */
  private static final double THIN = 0.25;

  /**
   * Scatter across the ring up to which it is one, as a share of the least variance of the events
   * of one polarity in any direction: events on a straight line fit a part of a large ring hardly
   * better than the line itself, whereas of half a ring it is a tenth of the squared radius.
   */
  private static final double CURVED = 0.7;

  /** Scatter of events that mark an outline as well as pixels can, pixels squared. */
  private static final double FIRST_SCATTER = 0.14;

  private static final double LEAST_SCATTER = 1.0 / 12;

  /** Scatter up to which events lie on a ring as closely as blurred pixels let them. */
  private static final double CLOSE_SCATTER = 0.2;

  /** Variance of the middle over what the scatter is more than that. */
  private static final double MISFIT = 5;

  /** What the reference may be off by, added to the scatter for the gate, pixels squared. */
  private static final double REFERENCE_VARIANCE = 0.15;

  private static final double GATE = 9;

  /** Radius of a cluster over that of the ring that it is: see {@link ClusterForm}. */
  static final double RING_RADII = 1.2;

  /** How far the first radius may be wrong, as a share of it. */
  private static final double FIRST_RADIUS_SHARE = 0.4;

  /** How the radius and the place of the reference wander, pixels squared a second. */
  private static final double RADIUS_WANDERS = 0.2;

  private static final double REFERENCE_WANDERS = 20;

  /** Readings in which the circle is looked for anew, at most. */
  private static final int FIRST_READINGS = 6;

  /** Variance of the radius over its square up to which that is needed. */
  private static final double SURE_SHARE = 0.01;

  /** Events over which the scatter is averaged, and without which nothing is known of it. */
  private static final double SCATTER_EVENTS = 200;

  private static final double LEAST_EVENTS = 15;

  /** Events taken between two readings where there are very many. */
  private static final double ENOUGH = 4;

  /** Up to the root of this and some more, all events are taken; above, fewer of more. */
  private static final double MANY = 1700;

  /** Variance of the middle from which on it is known, pixels squared. */
  private static final double SURE_VARIANCE = 1;

  /** Balance up to which a cluster has both polarities. */
  private static final double TWO_SIDED = 0.5;

  /** Share of the radius by which the events' middle may be off: that of half a ring is by 0.64. */
  private static final double MOST_OFFSET = 0.75;

  /** Radius up to which a ring can be the cluster's, over the cluster's own. */
  private static final double MOST_RADIUS = 1.2;

  /** Share of the way to the middle that a centre goes at an upkeep. */
  private static final double CENTRING = 0.1;

  /** Numbers of an event that waits, and how many of these there may be. */
  private static final int NUMBERS = 5;

  private static final int ROOM = 32;

  private static final double LEAST_DISTANCE = 0.5;
  private static final double PLACE_VARIANCE = 9;

  /** Whether the events of the cluster are looked at. */
  private boolean on;

  /** Whether a ring fits them better than a line. */
  private boolean curved;

  /** Of the events since the last reading. */
  private final OutlineSums sums = new OutlineSums();

  /** Fits what is hardly known yet. */
  private final FirstOutline first = new FirstOutline(sums);

  /** For how many more readings that does so at most. */
  private int firstReadings;

  /**
   * By how much the radius was expected to be larger than the one about which events are fitted.
   */
  private double expectedMove;

  /** Of how many events one is taken. */
  private int stride;

  private double radius;
  private double radiusVariance;
  private double scatter;
  private double freedom;
  private double offsetX;
  private double offsetY;
  private double offsetVariance;
  private double baseX;
  private double baseY;
  private long fromUs;

  // Events that wait to be fitted: offset from the reference, offset of the reference from where it
  // was expected, weight.
  private final double[] events = new double[NUMBERS * ROOM];
  private int waiting;

  /** Information on the centre that the last reading had, 0 if there was none. */
  double informationXx;

  double informationXy;
  double informationYy;

  /** That information times the centre at {@link #fromUs}. */
  double vectorX;

  double vectorY;

  /** Knows nothing, and looks at no event. */
  void end() {
    on = false;
    waiting = 0;
    informationXx = 0;
    informationXy = 0;
    informationYy = 0;
  }

  /** Takes an event, and the centre expected at its time, for the fit. */
  void take(Cluster cluster, double eventX, double eventY, double px, double py, double weight) {
    if (!on) {
      cluster.untilOutline = Integer.MAX_VALUE;
      return;
    }
    cluster.untilOutline = stride;
    if (firstReadings > 0) {
      first.take(eventX, eventY, (cluster.atUs - fromUs) * US, weight);
      return;
    }
    if (waiting == ROOM) {
      fit();
    }
    double qx = px + offsetX;
    double qy = py + offsetY;
    double seconds = (cluster.atUs - fromUs) * US;
    int at = NUMBERS * waiting++;
    events[at] = eventX - qx;
    events[at + 1] = eventY - qy;
    events[at + 2] = qx - cluster.vx * seconds - baseX;
    events[at + 3] = qy - cluster.vy * seconds - baseY;
    events[at + 4] = weight;
  }

  /** Takes the events that wait into the sums, all together, which is faster than one by one. */
  private void fit() {
    double gate = GATE * (scatter + REFERENCE_VARIANCE + radiusVariance);
    int end = NUMBERS * waiting;
    waiting = 0;
    for (int at = 0; at < end; at += NUMBERS) {
      double dx = events[at];
      double dy = events[at + 1];
      double distance = Math.sqrt(dx * dx + dy * dy);
      double off = distance - radius;
      if (distance < LEAST_DISTANCE || off * off > gate) {
        continue;
      }
      double perDistance = 1 / distance;
      double nx = dx * perDistance;
      double ny = dy * perDistance;
      double m = off + nx * events[at + 2] + ny * events[at + 3];
      sums.add(nx, ny, m, events[at + 4]);
    }
  }

  /** Looks for the circle about which the events are to be fitted, where it is not known yet. */
  private void fitFirst(Cluster cluster) {
    if (!first.fit(cluster.vx, cluster.vy, radius, ridge(), scatter, 2 * cluster.radius)) {
      sums.clear();
      return;
    }
    expectedMove = radius - first.radius;
    radius = first.radius;
    baseX = first.x;
    baseY = first.y;
    double seconds = (cluster.atUs - fromUs) * US;
    offsetX = baseX + cluster.vx * seconds - cluster.x;
    offsetY = baseY + cluster.vy * seconds - cluster.y;
  }

  /** Works out what a reading says, and learns from it. */
  void read(Cluster cluster) {
    informationXx = 0;
    informationXy = 0;
    informationYy = 0;
    if (firstReadings > 0) {
      fitFirst(cluster);
    } else {
      fit();
    }
    if (!on || sums.count <= 0) {
      return;
    }
    double known = ridge();
    sums.takeOutRadius(known, expectedMove);
    boolean isOutline = learn(cluster, known);
    if (isOutline && isThin()) {
      double perVariance = 1 / scatter;
      informationXx = sums.middleXx * perVariance;
      informationXy = sums.middleXy * perVariance;
      informationYy = sums.middleYy * perVariance;
      vectorX = sums.middleX * perVariance + informationXx * baseX + informationXy * baseY;
      vectorY = sums.middleY * perVariance + informationXy * baseX + informationYy * baseY;
    }
    if (!isOutline) {
      end();
    }
  }

  /** What is known of the radius from before, in units of an event. */
  private double ridge() {
    return scatter / radiusVariance;
  }

  /** Learns from the sums, and says whether they can be of the outline of the cluster's events. */
  private boolean learn(Cluster cluster, double known) {
    // The centre, if it is where it was expected give or take a few pixels.
    double loose = scatter / PLACE_VARIANCE;
    double jxx = sums.middleXx + loose;
    double jxy = sums.middleXy;
    double jyy = sums.middleYy + loose;
    double perDeterminant = 1 / (jxx * jyy - jxy * jxy);
    double cx = (jyy * sums.middleX - jxy * sums.middleY) * perDeterminant;
    double cy = (jxx * sums.middleY - jxy * sums.middleX) * perDeterminant;
    double radiusMoves = sums.radiusMove(cx, cy);
    learnScatter(cx, cy, radiusMoves);
    curved = scatter < CURVED * cluster.leastVariance();
    // With the centre taken out: what is left of the events to tell the radius.
    double kxx = sums.xx + loose;
    double kyy = sums.yy + loose;
    double taken =
        (kyy * sums.xr * sums.xr - 2 * sums.xy * sums.xr * sums.yr + kxx * sums.yr * sums.yr)
            / (kxx * kyy - sums.xy * sums.xy);
    radiusVariance = scatter / (known + Math.max(0, sums.count - taken));
    if (radiusVariance < SURE_SHARE * radius * radius) {
      firstReadings = 0;
    }
    radius = Math.min(2 * cluster.radius, Math.max(1, radius + radiusMoves));
    boolean isThere = !isElsewhere(cluster, offsetX + cx, offsetY + cy);
    moveReference(cluster);
    return isThere && !isElsewhere(cluster, offsetX, offsetY);
  }

  /**
   * Whether a middle that far from the cluster's centre is not that of its events: ON and OFF
   * events are on both sides of a thing's middle, and where they are few, those of a small thing
   * fit a part of a large ring beside it as well.
   */
  private boolean isElsewhere(Cluster cluster, double middleX, double middleY) {
    double most = MOST_OFFSET * radius;
    return Math.abs(cluster.balance) < TWO_SIDED
        && (radius > MOST_RADIUS * cluster.radius
            || middleX * middleX + middleY * middleY > most * most);
  }

  /** Takes the mean square of what is left over, per degree of freedom. */
  private void learnScatter(double cx, double cy, double radiusMoves) {
    double degrees = sums.count - 2 - sums.shareOfRadius();
    if (!(degrees > 0)) {
      return;
    }
    double rest = sums.rest(cx, cy, radiusMoves);
    freedom += degrees;
    double over = Math.max(degrees, Math.min(SCATTER_EVENTS, freedom + LEAST_EVENTS));
    scatter = Math.max(LEAST_SCATTER, scatter + (rest - degrees * scatter) / over);
  }

  /** Says where to look for the outline next time, relative to the cluster's centre. */
  private void moveReference(Cluster cluster) {
    double jxx = sums.middleXx;
    double jxy = sums.middleXy;
    double jyy = sums.middleYy;
    double tight = scatter / offsetVariance;
    double perDeterminant = 1 / ((jxx + tight) * (jyy + tight) - jxy * jxy);
    double seconds = (cluster.atUs - fromUs) * US;
    double nowX = cluster.x + offsetX - baseX - cluster.vx * seconds;
    double nowY = cluster.y + offsetY - baseY - cluster.vy * seconds;
    double wx = sums.middleX - jxx * nowX - jxy * nowY;
    double wy = sums.middleY - jxy * nowX - jyy * nowY;
    offsetX += ((jyy + tight) * wx - jxy * wy) * perDeterminant;
    offsetY += ((jxx + tight) * wy - jxy * wx) * perDeterminant;
    offsetVariance = scatter / (tight + 0.5 * (jxx + jyy));
    double squared = offsetX * offsetX + offsetY * offsetY;
    double most = cluster.radius;
    if (squared > most * most) {
      double shortened = most / Math.sqrt(squared);
      offsetX *= shortened;
      offsetY *= shortened;
    }
  }

  /** Begins to gather for the next reading; of a cluster that is new, with what its form is. */
  void next(Cluster cluster, long timeUs) {
    if (!on) {
      begin(cluster);
    } else {
      double seen = Math.max(1, stride * sums.count);
      stride = (int) Math.max(1, Math.round(seen / (ENOUGH + MANY / seen)));
      double seconds = (timeUs - fromUs) * US;
      radiusVariance += RADIUS_WANDERS * seconds;
      offsetVariance += REFERENCE_WANDERS * seconds;
    }
    first.clear();
    firstReadings = Math.max(0, firstReadings - 1);
    expectedMove = 0;
    cluster.sampleSoon();
    fromUs = timeUs;
    baseX = cluster.x + offsetX;
    baseY = cluster.y + offsetY;
    sums.clear();
  }

  private void begin(Cluster cluster) {
    on = true;
    curved = false;
    firstReadings = FIRST_READINGS;
    stride = 1;
    radius = cluster.radius / RING_RADII;
    radius = Math.max(1, radius);
    radiusVariance = FIRST_RADIUS_SHARE * radius * FIRST_RADIUS_SHARE * radius;
    scatter = FIRST_SCATTER;
    freedom = 0;
    offsetX = 0;
    offsetY = 0;
    offsetVariance = 0.25 * radius * radius;
  }

  /**
   * Variance of where the middle of the thing is, however many events there are: what scatters more
   * than pixels let it is no ring. Of two rings taken for one it is that of the middle of one.
   */
  double misfitVariance() {
    return MISFIT * Math.max(0, scatter - CLOSE_SCATTER);
  }

  /** Whether it is known where the middle of the outline is. */
  boolean isPlaced() {
    return isThin() && offsetVariance < SURE_VARIANCE;
  }

  private boolean isThin() {
    return on && curved && freedom >= LEAST_EVENTS && scatter < THIN * THIN * radius * radius;
  }

  /**
   * Moves the centre of a cluster whose events are all of one polarity towards the middle of the
   * outline, and says how far ahead of it they are.
   *
   * @param side 1 if the events are ON events, -1 if they are OFF events
   */
  void centre(Cluster cluster, int side) {
    double moveX = CENTRING * offsetX;
    double moveY = CENTRING * offsetY;
    cluster.x += moveX;
    cluster.y += moveY;
    cluster.leadX -= side * moveX;
    cluster.leadY -= side * moveY;
    offsetX -= moveX;
    offsetY -= moveY;
  }
}
