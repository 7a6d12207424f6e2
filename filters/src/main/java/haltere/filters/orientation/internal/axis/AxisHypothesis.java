package haltere.filters.orientation.internal.axis;

import haltere.filters.estimation.GaussianState;
import haltere.filters.orientation.camera.Vectors;
import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * A hypothesis of an axis and its velocity: a point u of the unit sphere, an orthonormal frame e₁,
 * e₂ of its tangent plane, which is transported in parallel, and a Gaussian of (a, ȧ, b, ḃ): angles
 * of the true axis from u along e₁ and e₂, of mean 0 between updates, and their rates. The rotation
 * about u, which no camera sees, is no state.
 *
 * <p>In a time step the axis moves on a great circle by the arc s = |v| g, with g = τ(1 − d) and d
 * = e^(−Δt/τ), and the velocity decays to d v. Errors along (t) and across (n) the motion follow
 * Jacobi's equation on the sphere:
 *
 * <pre>
 * a_t ← a_t + g ȧ_t              ȧ_t ← d ȧ_t
 * a_n ← cos s a_n + (g/s) sin s ȧ_n    ȧ_n ← d (cos s ȧ_n − (s/g) sin s a_n)
 * </pre>
 *
 * <p>Reused; nothing is allocated by a step.
 */
final class AxisHypothesis {
  /** Variance in one direction above which a hypothesis is split, because of nonlinearity. */
  private static final double WIDE_VARIANCE = Math.toRadians(12) * Math.toRadians(12);

  /** Standard deviation of each of three hypotheses over that of the one that is split. */
  private static final double NARROWER = 0.6;

  /** Log odds of backward flight above which head and tail are exchanged. */
  private static final double FLIES_BACKWARDS = 2;

  final double[] u = new double[3];
  final double[] e1 = new double[3];
  final double[] e2 = new double[3];
  final GaussianState error = new GaussianState(4);

  /** Transition of errors over the last step. */
  final DMatrixRMaj transition = new DMatrixRMaj(4, 4);

  /** Log probability during an update, up to a common term. */
  double logWeight;

  /** Its probability if any hypothesis is true. */
  double weight;

  /** Probability of a saccade if this hypothesis is true. */
  double saccadeShare;

  /** Log likelihood of its angle to the flight at the last coupling. */
  private double flightLog;

  /** Number of lines that are not yet used or rejected. */
  int undecided;

  private int lines;
  boolean[] decided = new boolean[16];

  /** By line: normalised innovation squared and {@link LineComparison#own}; NaN until used. */
  double[] nis = new double[16];

  double[] own = new double[16];

  /** For a smoother: path up to the last time, and the state before this time's lines. */
  AxisStep step;

  AxisState predicted;
  private final double[] row = new double[4];

  void copy(AxisHypothesis other) {
    System.arraycopy(other.u, 0, u, 0, 3);
    System.arraycopy(other.e1, 0, e1, 0, 3);
    System.arraycopy(other.e2, 0, e2, 0, 3);
    System.arraycopy(other.transition.data, 0, transition.data, 0, 16);
    error.set(other.error);
    logWeight = other.logWeight;
    weight = other.weight;
    saccadeShare = other.saccadeShare;
    undecided = other.undecided;
    lines = other.lines;
    reserve(lines);
    System.arraycopy(other.decided, 0, decided, 0, lines);
    System.arraycopy(other.nis, 0, nis, 0, lines);
    System.arraycopy(other.own, 0, own, 0, lines);
    flightLog = other.flightLog;
    step = other.step;
    predicted = other.predicted;
  }

  /** Starts with an axis, its covariance in the world and the variance of its rates. */
  void launch(double[] axis, double[] covariance, double rateVariance) {
    System.arraycopy(axis, 0, u, 0, 3);
    Vectors.normalise(u);
    System.arraycopy(Vectors.orthogonalTo(u), 0, e1, 0, 3);
    Vectors.cross(u, e1, e2);
    error.mean().zero();
    double[] by1 = new double[3];
    double[] by2 = new double[3];
    Vectors.multiply(covariance, e1, by1);
    Vectors.multiply(covariance, e2, by2);
    error.setVariances(Vectors.dot(e1, by1), rateVariance, Vectors.dot(e2, by2), rateVariance);
    error.addNoise(0, 2, Vectors.dot(e1, by2));
    CommonOps_DDRM.setIdentity(transition);
    flightLog = 0;
    step = null;
    predicted = null;
  }

  void set(AxisState state) {
    System.arraycopy(state.u(), 0, u, 0, 3);
    System.arraycopy(state.e1(), 0, e1, 0, 3);
    System.arraycopy(state.e2(), 0, e2, 0, 3);
    error.mean().zero();
    error.setMean(1, state.va());
    error.setMean(3, state.vb());
    System.arraycopy(state.p(), 0, error.covariance().data, 0, 16);
  }

  /** Predicts by a step, without its noise. */
  void predict(RateDecay decay) {
    double va = error.mean(1);
    double vb = error.mean(3);
    double speed = Math.sqrt(va * va + vb * vb);
    double arc = speed * decay.reachS;
    double ta = speed > 0 ? va / speed : 1;
    double tb = speed > 0 ? vb / speed : 0;
    setTransition(-tb, ta, arc, speed, decay);
    transport(ta, tb, arc);
    error.setMean(1, va * decay.left);
    error.setMean(3, vb * decay.left);
    error.transform(transition);
  }

  /**
   * Sets the transition: that along the motion for both directions, plus the difference across (n).
   */
  private void setTransition(double na, double nb, double s, double speed, RateDecay decay) {
    double g = decay.reachS;
    double left = decay.left;
    double sin = Math.sin(s);
    double fall = s < 1e-4 ? -s * s / 2 : Math.cos(s) - 1;
    double angleByRate = s < 1e-4 ? -g * s * s / 6 : g * (sin / s - 1);
    double[] f = transition.data;
    for (int i = 0; i < 4; i += 2) {
      for (int j = 0; j < 4; j += 2) {
        double across = (i == 0 ? na : nb) * (j == 0 ? na : nb);
        double same = i == j ? 1 : 0;
        f[4 * i + j] = same + fall * across;
        f[4 * i + j + 1] = same * g + angleByRate * across;
        f[4 * i + 4 + j] = -left * speed * sin * across;
        f[4 * i + 5 + j] = left * (same + fall * across);
      }
    }
  }

  /** The noise of a step, of rates with a variance. */
  void addNoise(RateDecay decay, double rateVariance) {
    for (int i = 0; i < 4; i += 2) {
      error.addNoise(i, rateVariance * decay.angleNoise);
      error.addNoise(i + 1, rateVariance * decay.rateNoise);
      error.addNoise(i, i + 1, rateVariance * decay.jointNoise);
    }
  }

  /** Moves u by an arc in a tangent direction, with parallel transport of e₁ and e₂. */
  private void transport(double ta, double tb, double arc) {
    if (arc < 1e-300) {
      return;
    }
    double cos = Math.cos(arc);
    double sin = Math.sin(arc);
    for (int i = 0; i < 3; i++) {
      double ahead = ta * e1[i] + tb * e2[i];
      double across = ta * e2[i] - tb * e1[i];
      double newAhead = cos * ahead - sin * u[i];
      u[i] = cos * u[i] + sin * ahead;
      e1[i] = ta * newAhead - tb * across;
    }
    Vectors.normalise(u);
    double along = Vectors.dot(e1, u);
    for (int i = 0; i < 3; i++) {
      e1[i] -= along * u[i];
    }
    Vectors.normalise(e1);
    Vectors.cross(u, e1, e2);
  }

  /** Starts an update with a number of lines. */
  void expect(int count) {
    reserve(count);
    Arrays.fill(decided, 0, count, false);
    Arrays.fill(nis, 0, count, Double.NaN);
    Arrays.fill(own, 0, count, Double.NaN);
    undecided = count;
    lines = count;
  }

  private void reserve(int count) {
    if (decided.length < count) {
      decided = Arrays.copyOf(decided, count);
      nis = Arrays.copyOf(nis, count);
      own = Arrays.copyOf(own, count);
    }
  }

  /** Updates with a compared line. */
  void accept(int index, LineComparison seen) {
    own[index] = seen.own();
    nis[index] = seen.nis();
    decided[index] = true;
    undecided--;
    correct(seen.ha, seen.hb, seen.innovation, seen.noise);
  }

  private void correct(double ha, double hb, double innovation, double variance) {
    row[0] = ha;
    row[2] = hb;
    error.project(row);
    error.correct(innovation, variance);
  }

  /** Exchanges head and tail if the tail is much likelier to point in a direction. */
  void face(double[] direction, double variance) {
    double angle = Vectors.angle(u, direction);
    double opposite = logOf(Math.PI - angle, variance);
    if (opposite - logOf(angle, variance) > FLIES_BACKWARDS) {
      reverse();
      flightLog = opposite;
    }
  }

  private static double logOf(double angle, double variance) {
    return -0.5 * angle * angle / variance;
  }

  /**
   * Updates with the direction of flight, that of the axis plus a slip angle with a fresh share;
   * sets {@link #logWeight} to its likelihood. The angle is a first-order Gauss-Markov process: its
   * likelihood is relative to that of the part counted before.
   */
  void coupleToFlight(double[] direction, double variance, double fresh) {
    double a = Vectors.dot(direction, e1);
    double b = Vectors.dot(direction, e2);
    double sin = Math.sqrt(a * a + b * b);
    double angle = Math.atan2(sin, Vectors.dot(direction, u));
    double scale = sin < 1e-7 ? 1 : angle / sin;
    double log = logOf(angle, variance);
    logWeight = log - (1 - fresh) * flightLog;
    flightLog = log;
    correct(1, 0, scale * a, variance / fresh);
    correct(0, 1, scale * b - error.mean(2), variance / fresh);
    recentre(true);
  }

  /** Exchanges head and tail; a smoother stops at this time. */
  private void reverse() {
    for (int k = 0; k < 3; k++) {
      u[k] = -u[k];
      e1[k] = -e1[k];
    }
    error.setMean(3, -error.mean(3));
    error.scale(2, -1);
    error.scale(3, -1);
    if (step != null) {
      step = new AxisStep(null, null, state(), step.before());
    }
  }

  /** Moves the mean by a difference (a, ȧ, b, ḃ) along a great circle; the covariance stays. */
  void move(double[] by) {
    for (int i = 0; i < 4; i++) {
      error.setMean(i, error.mean(i) + by[i]);
    }
    recentre(false);
  }

  /** Moves the axis by the mean angles: a tangent, or an arc of a great circle. */
  void recentre(boolean isTangent) {
    double a = error.mean(0);
    double b = error.mean(2);
    double off = Math.sqrt(a * a + b * b);
    if (off > 0) {
      transport(a / off, b / off, isTangent ? Math.atan(off) : off);
    }
    error.setMean(0, 0);
    error.setMean(2, 0);
  }

  /**
   * Narrows the Gaussian along its widest direction; false if it is narrow enough. The shift gets
   * the offset of two others on both sides; the three with weights 1 : 2 : 1 have its mean and
   * covariance.
   */
  boolean narrow(double[] shift) {
    double p00 = error.covariance(0, 0);
    double p02 = error.covariance(0, 2);
    double p22 = error.covariance(2, 2);
    double half = 0.5 * (p00 - p22);
    double largest = 0.5 * (p00 + p22) + Math.sqrt(half * half + p02 * p02);
    if (!(largest > WIDE_VARIANCE)) {
      return false;
    }
    double angle = 0.5 * Math.atan2(p02, half);
    double wa = Math.cos(angle);
    double wb = Math.sin(angle);
    double sd = Math.sqrt(largest);
    for (int i = 0; i < 4; i++) {
      shift[i] = (error.covariance(i, 0) * wa + error.covariance(i, 2) * wb) / sd;
    }
    double[] p = error.covariance().data;
    for (int i = 0; i < 16; i++) {
      p[i] -= (1 - NARROWER * NARROWER) * (shift[i / 4] * shift[i % 4]);
    }
    for (int i = 0; i < 4; i++) {
      shift[i] *= Math.sqrt(2 * (1 - NARROWER * NARROWER));
    }
    return true;
  }

  /** The state for a smoother. */
  AxisState state() {
    double[] p = error.covariance().data.clone();
    return new AxisState(u.clone(), e1.clone(), e2.clone(), error.mean(1), error.mean(3), p);
  }

  /** Mean squared angle to the true axis. */
  double angleVariance() {
    return error.covariance(0, 0) + error.covariance(2, 2);
  }

  boolean isValid() {
    return error.isValid()
        && Double.isFinite(u[0] + u[1] + u[2])
        && error.covariance(0, 0) > 0
        && error.covariance(2, 2) > 0;
  }
}
