package haltere.filters.wing.internal.search;

import haltere.filters.estimation.Angles;
import haltere.filters.wing.internal.stroke.StrokeSeed;
import java.util.Arrays;

/**
 * Fits the stroke of one wing to the events of a few beats by Gauss-Newton with robust weights and
 * weak priors: hinge, Fourier series of the angle over the beat, half width between the edges, lag
 * of ON behind OFF events.
 *
 * <p>Angles are measured from a direction (the heading or its opposite) counterclockwise for turn
 * 1, clockwise for turn -1.
 */
final class StrokeFit {
  static final int HARMONICS = 4;

  static final int CENTRE = 0;
  private static final int OMEGA = 1;
  static final int HINGE_X = 2;
  static final int HINGE_Y = 3;
  private static final int WIDTH = 4;
  private static final int LAG = 5;
  private static final int SERIES = 6;
  static final int SIZE = SERIES + 2 * HARMONICS;
  private static final int ROUNDS = 18;
  private static final int WITH_HARMONICS = 3;
  private static final int WITH_HINGE = 6;
  private static final int WITH_EDGES = 10;
  private static final double MAX_STEP_PX = 1.5;
  private static final double FURTHEST_PX = 10;

  /** Prior standard deviation of the hinge about its start. */
  private static final double SLACK_PX = 3;

  private static final int QUICK_ROUNDS = 10;
  private static final int QUICK_EVENTS = 800;
  private static final int MAX_EVENTS = 3000;
  private static final double PIXEL = 0.7;
  private static final double SHAPE_RAD = 0.01;
  private static final double TIMING_S = 40e-6;
  private static final double[] SERIES_SD = {1, 0.08, 0.03, 0.012};

  /** Residual with a weight of a quarter, in standard deviations. */
  private static final double WIDE = 2.5;

  static final double BOUND_SD_RAD = 1e-3;

  /** Parts of a beat: four harmonics have as many independent values. */
  private static final int PARTS = 2 * HARMONICS;

  private final NormalEquations normal = new NormalEquations(SIZE);
  private final double[] step = new double[SIZE];
  private final double[] row = new double[SIZE];

  /** Centre, angular frequency, hinge, half width, lag of ON behind OFF, terms of the series. */
  final double[] p = new double[SIZE];

  /** Number of events of the side, and the sum of their weights. */
  int events;

  double inliers;

  /** Root mean square of the weighted residuals, in standard deviations. */
  double residual;

  /** Negative log-likelihood of the OFF and of the ON events in each part of a beat. */
  final double[] losses = new double[2 * PARTS];

  /** End of the fly that is towards the reference: 1 the head, -1 the tail, 0 not stated. */
  private int end;

  private double boundRad;
  private boolean isBound;

  private final CoarseStroke coarse = new CoarseStroke();
  private int stride = 1;
  private final double[] prior = new double[SERIES];
  private SideSplit split;
  private int side;
  private double outerPx;
  private double referenceRad;
  private double turn;
  private double middleS;

  double centre() {
    return p[CENTRE];
  }

  double hingeX() {
    return p[HINGE_X];
  }

  double hingeY() {
    return p[HINGE_Y];
  }

  double cosine(int harmonic) {
    return p[SERIES + 2 * harmonic - 2];
  }

  double sine(int harmonic) {
    return p[SERIES + 2 * harmonic - 1];
  }

  double amplitude() {
    return Math.hypot(cosine(1), sine(1));
  }

  /** Stroke beyond the cross line, mean of centre and middle; puts derivatives in {@link #row}. */
  double asymmetry() {
    double low = 0;
    double high = 0;
    for (double phase = 0; phase < 2 * Math.PI; phase += Math.PI / 32) {
      low = swing(phase) < swing(low) ? phase : low;
      high = swing(phase) > swing(high) ? phase : high;
    }
    Arrays.fill(row, 0);
    row[CENTRE] = 1;
    for (int k = 1; k <= HARMONICS; k++) {
      row[SERIES + 2 * k - 2] = (Math.cos(k * low) + Math.cos(k * high)) / 4;
      row[SERIES + 2 * k - 1] = (Math.sin(k * low) + Math.sin(k * high)) / 4;
    }
    return centre() + (swing(low) + swing(high)) / 4 - Math.PI / 2;
  }

  private double swing(double phase) {
    double value = 0;
    for (int k = 1; k <= HARMONICS; k++) {
      value += cosine(k) * Math.cos(k * phase) + sine(k) * Math.sin(k * phase);
    }
    return value;
  }

  /** The stroke as a seed; flipped angles are measured from the opposite direction. */
  StrokeSeed seed(long startUs, boolean flipped) {
    double sign = flipped ? -1 : 1;
    double phase = Math.atan2(sign * cosine(1), sign * sine(1));
    double[] cosines = new double[HARMONICS - 1];
    double[] sines = new double[HARMONICS - 1];
    for (int k = 2; k <= HARMONICS; k++) {
      double c = Math.cos(k * phase);
      double s = Math.sin(k * phase);
      cosines[k - 2] = sign * (cosine(k) * c - sine(k) * s);
      sines[k - 2] = sign * (cosine(k) * s + sine(k) * c);
    }
    return new StrokeSeed(
        startUs + Math.round(middleS * 1e6),
        flipped ? Math.PI - centre() : centre(),
        amplitude(),
        phase,
        p[OMEGA],
        p[WIDTH],
        p[LAG],
        cosines,
        sines);
  }

  /**
   * Fits.
   *
   * @param events divided into sides
   * @param own the side: 0 for angles counterclockwise of the reference, 1 for clockwise
   * @param reference direction from which angles are measured
   * @param hingeX initial hinge
   * @param hingeY initial hinge
   * @param farthestPx largest distance of an event from the hinge
   * @param startOmega initial angular frequency
   * @param quick whether the hinge to the nearest pixel is sufficient
   * @return false if there are too few events
   */
  boolean fit(
      SideSplit events,
      int own,
      double reference,
      double hingeX,
      double hingeY,
      double farthestPx,
      double startOmega,
      boolean quick) {
    end = 0;
    split = events;
    side = own;
    referenceRad = reference;
    turn = own == 0 ? 1 : -1;
    outerPx = farthestPx;
    StrokeSample sample = events.sample;
    middleS = sample.size == 0 ? 0 : sample.timeS[sample.size - 1] / 2;
    stride = Math.max(1, split.count(side) / (quick ? QUICK_EVENTS : MAX_EVENTS));
    return fit(hingeX, hingeY, startOmega, quick ? QUICK_ROUNDS : ROUNDS);
  }

  /** Fits the events of another fit; asymmetry above a bound for end 1, below it for −1. */
  boolean fit(StrokeFit fit, int stated, double bound) {
    end = stated;
    boundRad = bound;
    split = fit.split;
    side = fit.side;
    referenceRad = fit.referenceRad;
    turn = fit.turn;
    outerPx = fit.outerPx;
    middleS = fit.middleS;
    stride = fit.stride;
    return fit(fit.prior[HINGE_X], fit.prior[HINGE_Y], fit.prior[OMEGA], ROUNDS);
  }

  private boolean fit(double hingeX, double hingeY, double startOmega, int rounds) {
    isBound = false;
    Arrays.fill(p, 0);
    p[OMEGA] = startOmega;
    p[HINGE_X] = hingeX;
    p[HINGE_Y] = hingeY;
    p[WIDTH] = 0.03;
    System.arraycopy(p, 0, prior, 0, SERIES);
    if (!coarse()) {
      return false;
    }
    for (int round = 0; round < rounds; round++) {
      int unknowns = round < WITH_HARMONICS ? SERIES + 2 : SIZE;
      if (!accumulate(round) || !normal.solve(unknowns, step)) {
        return false;
      }
      double moved = Math.hypot(step[HINGE_X], step[HINGE_Y]);
      double share = moved > MAX_STEP_PX ? MAX_STEP_PX / moved : 1;
      for (int i = 0; i < unknowns; i++) {
        p[i] += share * step[i];
      }
      if (Math.hypot(p[HINGE_X] - hingeX, p[HINGE_Y] - hingeY) > FURTHEST_PX) {
        return false;
      }
      p[WIDTH] = Math.max(0, p[WIDTH]);
    }
    return true;
  }

  private boolean coarse() {
    if (!coarse.search(
        split, side, p[HINGE_X], p[HINGE_Y], outerPx, referenceRad, turn, p[OMEGA], middleS, end)) {
      return false;
    }
    p[CENTRE] = coarse.centre;
    p[SERIES] = coarse.cosine;
    p[SERIES + 1] = coarse.sine;
    return true;
  }

  /** The stroke angle of a point about the hinge, nearest to a given one. */
  static double near(double angle, double to) {
    return to + Angles.wrapPi(angle - to);
  }

  private boolean accumulate(int round) {
    StrokeSample sample = split.sample;
    normal.clear();
    addPrior(CENTRE, 1.7, 0.5);
    addPrior(OMEGA, prior[OMEGA], 2 * Math.PI * 8);
    addPrior(HINGE_X, prior[HINGE_X], round < WITH_HINGE ? 1e-4 : SLACK_PX);
    addPrior(HINGE_Y, prior[HINGE_Y], round < WITH_HINGE ? 1e-4 : SLACK_PX);
    addPrior(WIDTH, 0.03, round < WITH_EDGES ? 1e-6 : 0.03);
    addPrior(LAG, 0, round < WITH_EDGES ? 1e-9 : 200e-6);
    for (int k = 1; k <= HARMONICS; k++) {
      addPrior(SERIES + 2 * k - 2, 0, SERIES_SD[k - 1]);
      addPrior(SERIES + 2 * k - 1, 0, SERIES_SD[k - 1]);
    }
    double wide =
        round < WITH_HARMONICS ? 6 : round < WITH_HINGE ? 4 : round < WITH_EDGES ? 3 : WIDE;
    int harmonics = round < WITH_HARMONICS ? 1 : HARMONICS;
    events = 0;
    inliers = 0;
    double squares = 0;
    Arrays.fill(losses, 0);
    isBound |= end != 0 && end * (asymmetry() - boundRad) < 0;
    if (isBound) {
      normal.add(1 / (BOUND_SD_RAD * BOUND_SD_RAD), row, SIZE, boundRad - asymmetry());
    }
    double outerSquare = outerPx * outerPx;
    int seen = 0;
    for (int i = 0; i < sample.size; i++) {
      if (!split.isOn(side, i) || ++seen % stride != 0) {
        continue;
      }
      double dx = sample.x[i] - p[HINGE_X];
      double dy = sample.y[i] - p[HINGE_Y];
      double rr = dx * dx + dy * dy;
      double sign = sample.sign[i];
      double beats = prior[OMEGA] * (sample.timeS[i] - middleS) / (2 * Math.PI);
      int part = (int) (PARTS * (beats - Math.floor(beats))) % PARTS + (sign < 0 ? PARTS : 0);
      if (rr < 9 || rr > outerSquare) {
        losses[part] += WIDE * WIDE / 2;
        continue;
      }
      events++;
      double sinceS = sample.timeS[i] - middleS - (sign < 0 ? p[LAG] : 0);
      double c1 = Math.cos(p[OMEGA] * sinceS);
      double s1 = Math.sin(p[OMEGA] * sinceS);
      double c = c1;
      double s = s1;
      double model = p[CENTRE];
      double slope = 0;
      for (int k = 1; k <= harmonics; k++) {
        int at = SERIES + 2 * k - 2;
        model += p[at] * c + p[at + 1] * s;
        slope += k * (p[at + 1] * c - p[at] * s);
        row[at] = c;
        row[at + 1] = s;
        double next = c * c1 - s * s1;
        s = s * c1 + c * s1;
        c = next;
      }
      double speed = slope * p[OMEGA];
      double ahead = speed >= 0 ? sign : -sign;
      model += ahead * p[WIDTH];
      double angle = turn * (Math.atan2(dy, dx) - referenceRad);
      double y = Angles.wrapPi(near(angle, p[CENTRE]) - model);
      double variance =
          SHAPE_RAD * SHAPE_RAD + PIXEL * PIXEL / rr + speed * speed * (TIMING_S * TIMING_S);
      double scaled = y * y / (variance * wide * wide);
      double w = 1 / ((1 + scaled) * (1 + scaled));
      inliers += w;
      losses[part] += WIDE * WIDE / 2 * scaled / (1 + scaled);
      squares += w * y * y / variance;
      row[CENTRE] = 1;
      row[OMEGA] = slope * sinceS;
      // the residual falls by these when the hinge moves
      // (and the distance, in which the residual counts, changes with it)
      row[HINGE_X] = (y * dx - turn * dy) / rr;
      row[HINGE_Y] = (y * dy + turn * dx) / rr;
      row[WIDTH] = ahead;
      row[LAG] = sign < 0 ? -speed : 0;
      normal.add(w / variance, row, SERIES + 2 * harmonics, y);
    }
    residual = inliers > 0 ? Math.sqrt(squares / inliers) : 0;
    return events >= 50;
  }

  /**
   * Adds the information of the fit to larger equations from an unknown on, divided by a number of
   * correlated events.
   */
  void addTo(NormalEquations equations, int from, double repeating) {
    equations.addInformation(normal, from, 1 / (repeating * Math.max(1, residual * residual)));
  }

  private void addPrior(int index, double value, double sd) {
    normal.addPrior(index, value - p[index], sd);
  }
}
