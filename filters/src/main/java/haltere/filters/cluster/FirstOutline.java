package haltere.filters.cluster;

/**
 * The circle through the first events of a cluster, whose middle and radius are not known well
 * enough yet for {@link ClusterContour}'s straight lines: what has begun to enter shows an arc, and
 * the mean of an arc is far from its middle.
 *
 * <p>Events are kept until they are fitted. A first circle is that of I. Kåsa (1976), "A circle
 * fitting procedure and its error analysis", IEEE Transactions on Instrumentation and Measurement
 * 25: |z|² = 2 c z + const, least squares, which needs no beginning. Steps of Gauss and Newton lead
 * from there to the least sum of the squared distances from the circle, with what is known of the
 * radius. Thread rule: that of its owner.
 */
final class FirstOutline {
  /** Events of which a circle is made, at most; of more, one of two, of four and so on is kept. */
  private static final int ROOM = 32;

  private static final int NUMBERS = 4;
  private static final int LEAST_EVENTS = 6;
  private static final int STEPS = 4;

  /** Squared distance from the circle, over its expectation, from which on an event is noise. */
  private static final double GATE = 9;

  /** What the circle may still be off by while steps are taken, pixels squared. */
  private static final double LOOSE_VARIANCE = 0.5;

  /** The same when they have been taken. */
  private static final double TIGHT_VARIANCE = 0.15;

  /** Share of the events that must lie on the circle. */
  private static final double MOST = 0.8;

  /** Scatter about the circle over that about a straight line up to which it is believed. */
  private static final double CURVED = 0.5;

  /** The same over what is expected: events of noise lie near some circle, but not so near. */
  private static final double SHARP = 2;

  /** Of a circle. */
  private static final int PARAMETERS = 3;

  private static final double LEAST_DISTANCE = 0.5;

  // Place, time since the last reading in seconds, weight.
  private final double[] events = new double[NUMBERS * ROOM];
  private final OutlineSums sums;

  /** Variance of the events across the straight line that fits them best. */
  private double lineVariance;

  private int count;
  private int every;
  private int skipped;

  /** The middle at the last reading. */
  double x;

  double y;
  double radius;

  /** Leaves its sums about the circle that it finds. */
  FirstOutline(OutlineSums sums) {
    this.sums = sums;
  }

  void clear() {
    count = 0;
    every = 1;
    skipped = 0;
  }

  void take(double eventX, double eventY, double seconds, double weight) {
    if (++skipped < every) {
      return;
    }
    skipped = 0;
    if (count == ROOM) {
      thin();
    }
    int at = NUMBERS * count++;
    events[at] = eventX;
    events[at + 1] = eventY;
    events[at + 2] = seconds;
    events[at + 3] = weight;
  }

  private void thin() {
    count = ROOM / 2;
    every *= 2;
    for (int i = 1; i < count; i++) {
      System.arraycopy(events, 2 * i * NUMBERS, events, i * NUMBERS, NUMBERS);
    }
  }

  private double weight(int index) {
    return events[NUMBERS * index + 3];
  }

  /** Column of an event relative to where the middle was at its time. */
  private double offsetX(int index, double vx) {
    int at = NUMBERS * index;
    return events[at] - x - vx * events[at + 2];
  }

  /** Row of an event relative to where the middle was at its time. */
  private double offsetY(int index, double vy) {
    int at = NUMBERS * index;
    return events[at + 1] - y - vy * events[at + 2];
  }

  /**
   * Fits the circle.
   *
   * @param vx velocity of the thing, pixels a second
   * @param vy velocity of the thing, pixels a second
   * @param expected radius
   * @param ridge variance of an event across the outline over that of the expected radius
   * @param scatter variance of an event across the outline
   * @param most radius, pixels
   * @return whether there is one on which most events lie
   */
  boolean fit(double vx, double vy, double expected, double ridge, double scatter, double most) {
    if (count < LEAST_EVENTS) {
      return false;
    }
    double all = begin(vx, vy, expected, most);
    for (int i = 0; i < STEPS; i++) {
      step(vx, vy, expected, ridge, GATE * (scatter + LOOSE_VARIANCE), most);
    }
    gather(vx, vy, GATE * (scatter + TIGHT_VARIANCE));
    return Double.isFinite(x + y + radius) && sums.count >= MOST * all && isThin(scatter);
  }

  /** The circle of Kåsa, no larger than may be; gives back the weight of all events. */
  private double begin(double vx, double vy, double expected, double most) {
    double sum = 0;
    double meanX = 0;
    double meanY = 0;
    x = 0;
    y = 0;
    for (int i = 0; i < count; i++) {
      double w = weight(i);
      sum += w;
      meanX += w * offsetX(i, vx);
      meanY += w * offsetY(i, vy);
    }
    x = meanX / sum;
    y = meanY / sum;
    double xx = 0;
    double xy = 0;
    double yy = 0;
    double cubeX = 0;
    double cubeY = 0;
    for (int i = 0; i < count; i++) {
      double w = weight(i);
      double dx = offsetX(i, vx);
      double dy = offsetY(i, vy);
      double square = dx * dx + dy * dy;
      xx += w * dx * dx;
      xy += w * dx * dy;
      yy += w * dy * dy;
      cubeX += w * dx * square;
      cubeY += w * dy * square;
    }
    double determinant = 2 * (xx * yy - xy * xy);
    double a = determinant > 0 ? (yy * cubeX - xy * cubeY) / determinant : 0;
    double b = determinant > 0 ? (xx * cubeY - xy * cubeX) / determinant : 0;
    double far = Math.hypot(a, b);
    if (far > expected) {
      // Nearly a straight line: which side it bends to is all that it says.
      a *= expected / far;
      b *= expected / far;
    }
    x += a;
    y += b;
    radius = Math.min(most, Math.max(1, Math.sqrt(a * a + b * b + (xx + yy) / sum)));
    double half = 0.5 * (xx - yy);
    lineVariance = (0.5 * (xx + yy) - Math.sqrt(half * half + xy * xy)) / sum;
    return sum;
  }

  /** Whether events lie about the circle as of an edge, and clearly nearer than to a line. */
  private boolean isThin(double scatter) {
    double most = Math.min(CURVED * lineVariance, SHARP * scatter);
    return sums.squares < most * (sums.count - PARAMETERS);
  }

  /** Compares the events with the circle. */
  private void gather(double vx, double vy, double gate) {
    sums.clear();
    for (int i = 0; i < count; i++) {
      double dx = offsetX(i, vx);
      double dy = offsetY(i, vy);
      double distance = Math.sqrt(dx * dx + dy * dy);
      double off = distance - radius;
      if (distance >= LEAST_DISTANCE && off * off <= gate) {
        sums.add(dx / distance, dy / distance, off, weight(i));
      }
    }
  }

  /** One step of Gauss and Newton. */
  private void step(double vx, double vy, double expected, double ridge, double gate, double most) {
    gather(vx, vy, gate);
    sums.takeOutRadius(ridge, expected - radius);
    double jxx = sums.middleXx + ridge;
    double jxy = sums.middleXy;
    double jyy = sums.middleYy + ridge;
    double determinant = jxx * jyy - jxy * jxy;
    double moveX = (jyy * sums.middleX - jxy * sums.middleY) / determinant;
    double moveY = (jxx * sums.middleY - jxy * sums.middleX) / determinant;
    radius += sums.radiusMove(moveX, moveY);
    radius = Math.min(most, Math.max(1, radius));
    x += moveX;
    y += moveY;
  }
}
