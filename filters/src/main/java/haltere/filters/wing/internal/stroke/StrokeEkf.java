package haltere.filters.wing.internal.stroke;

import haltere.filters.estimation.GaussianState;
import java.util.Arrays;

/**
 * The extended Kalman filter of a wing's stroke. Its state is the centre a, the amplitude M, the
 * phase xi, the angular frequency omega, the half width w of the wing as seen, the lag of ON behind
 * OFF events, the rate of change of omega, and the terms c, s of the harmonics from the second on:
 *
 * <pre>h(xi) = a + M sin xi + sum over k from 2 of (c_k cos k xi + s_k sin k xi)</pre>
 *
 * An OFF event measures h(xi) + w sgn(h'), an ON event h(xi - omega lag) - w sgn(h').
 *
 * <p>Sine and cosine of the phase are rotated by small angles. Process noise is a spectral density.
 * Harmonics, width and lag are Ornstein-Uhlenbeck processes, so that unobserved ones return to
 * their usual values. Times in seconds, angles in radians.
 */
final class StrokeEkf {
  static final int CENTRE = 0;
  static final int AMPLITUDE = 1;
  static final int PHASE = 2;
  static final int OMEGA = 3;
  static final int WIDTH = 4;
  static final int LAG = 5;
  static final int RATE = 6;
  static final int SERIES = 7;

  final int harmonics;
  final int size;
  final GaussianState belief;

  /** Mean of the state, not a copy. */
  final double[] x;

  private final double[] h;
  private final double[] marked;
  private double expectedVariance;

  /** Cosine and sine of the phase. */
  double cos = 1;

  double sin;

  /** Derivative of the stroke angle at the last phase of {@link #angle}. */
  double slopeThere;

  /** Cosine and sine of omega times the lag. */
  double lagCos = 1;

  double lagSin;

  StrokeEkf(int harmonics) {
    this.harmonics = harmonics;
    size = SERIES + 2 * (harmonics - 1);
    belief = new GaussianState(size);
    x = belief.mean().data;
    h = new double[size];
    marked = new double[size];
  }

  /** Restarts with a state with independent errors. */
  void launch(double[] state, double[] sd) {
    double[] variances = new double[size];
    for (int i = 0; i < size; i++) {
      x[i] = state[i];
      variances[i] = sd[i] * sd[i];
    }
    belief.setVariances(variances);
    refresh();
  }

  private void refresh() {
    x[PHASE] = wrapped(x[PHASE]);
    cos = Math.cos(x[PHASE]);
    sin = Math.sin(x[PHASE]);
    lagCos = Math.cos(x[OMEGA] * x[LAG]);
    lagSin = Math.sin(x[OMEGA] * x[LAG]);
  }

  private static double wrapped(double angle) {
    return angle - 2 * Math.PI * Math.floor(angle / (2 * Math.PI));
  }

  /** Advances the phase; the covariance follows in {@link #predictCovariance}. */
  void turn(double angle) {
    if (Math.abs(angle) > 0.3) {
      x[PHASE] += angle;
      refresh();
      return;
    }
    double square = angle * angle;
    double s = angle * (1 - square * (1.0 / 6 - square * (1.0 / 120)));
    double c = 1 - square * (0.5 - square * (1.0 / 24 - square * (1.0 / 720)));
    double nextCos = cos * c - sin * s;
    double nextSin = sin * c + cos * s;
    double off = 1.5 - 0.5 * (nextCos * nextCos + nextSin * nextSin);
    cos = nextCos * off;
    sin = nextSin * off;
    double phase = x[PHASE] + angle;
    x[PHASE] = phase >= 2 * Math.PI ? phase - 2 * Math.PI : phase < 0 ? phase + 2 * Math.PI : phase;
  }

  /** Whether another state of equal size has the same stroke. */
  boolean hasSeries(double[] other) {
    return other.length == size
        && other[CENTRE] == x[CENTRE]
        && other[AMPLITUDE] == x[AMPLITUDE]
        && Arrays.equals(x, SERIES, size, other, SERIES, size);
  }

  /** Derivative of the stroke angle with respect to the phase. */
  double slope(double c1, double s1) {
    angle(c1, s1);
    return slopeThere;
  }

  /** Stroke angle at a phase given by its cosine and sine; {@link #slopeThere} keeps its slope. */
  double angle(double c1, double s1) {
    double value = x[CENTRE] + x[AMPLITUDE] * s1;
    double slope = x[AMPLITUDE] * c1;
    double c = c1;
    double s = s1;
    double k = 2;
    for (int i = SERIES; i < size; i += 2) {
      double next = c * c1 - s * s1;
      s = s * c1 + c * s1;
      c = next;
      double cosine = x[i];
      double sine = x[i + 1];
      value += cosine * c + sine * s;
      slope += k * (sine * c - cosine * s);
      k++;
    }
    slopeThere = slope;
    return value;
  }

  /** Stroke angle at an advanced phase; {@link #slopeThere} keeps its slope. */
  double angleAfter(double turn) {
    double c = Math.cos(turn);
    double s = Math.sin(turn);
    return angle(cos * c - sin * s, sin * c + cos * s);
  }

  /**
   * Predicts the covariance by a time step with the process noise densities of the first entries.
   */
  void predictCovariance(double dtS, double[] density) {
    belief.shearCovariance(PHASE, OMEGA, dtS);
    belief.shear(OMEGA, RATE, dtS);
    for (int i = 0; i < density.length; i++) {
      belief.addNoise(i, density[i] * dtS);
    }
  }

  /** Sets the measurement Jacobian at a phase: edge 1 for OFF, -1 for ON, 0 for the middle. */
  void look(double c1, double s1, int edge) {
    double slope = slope(c1, s1);
    double ahead = slope >= 0 ? edge : -edge;
    boolean on = edge < 0;
    h[CENTRE] = 1;
    h[AMPLITUDE] = s1;
    h[PHASE] = slope;
    h[OMEGA] = on ? -slope * x[LAG] : 0;
    h[WIDTH] = ahead;
    h[LAG] = on ? -slope * x[OMEGA] : 0;
    h[RATE] = 0;
    double c = c1;
    double s = s1;
    for (int i = SERIES; i < size; i += 2) {
      double next = c * c1 - s * s1;
      s = s * c1 + c * s1;
      c = next;
      h[i] = c;
      h[i + 1] = s;
    }
    expectedVariance = belief.project(h);
  }

  /** Variance of the present angle of the middle, 0, or of an edge on one of its sides. */
  double angleVariance(int at) {
    look(cos, sin, 0);
    if (at != 0) {
      h[WIDTH] = at;
      expectedVariance = belief.project(h);
    }
    return expectedVariance;
  }

  /** Variance of the expected measurement of {@link #look}. */
  double expectedVariance() {
    return expectedVariance;
  }

  /** Change of the expected measurement of {@link #look} since {@link #mark}. */
  double movedBy() {
    double sum = 0;
    for (int i = 0; i < size; i++) {
      sum += h[i] * (x[i] - marked[i]);
    }
    return sum;
  }

  /** Keeps the state, for {@link #movedBy} and {@link #settle}. */
  void mark() {
    System.arraycopy(x, 0, marked, 0, size);
  }

  /** Updates with the measurement of {@link #look}. */
  void update(double innovation, double variance) {
    belief.correct(innovation, variance);
  }

  /** Ends a series of updates: recomputes derived values. */
  void settle() {
    double turned = x[PHASE] - marked[PHASE];
    if (turned != 0) {
      x[PHASE] = marked[PHASE];
      turn(turned);
    }
    double lag = x[OMEGA] * x[LAG];
    lagSin = Math.sin(lag);
    lagCos = Math.cos(lag);
  }

  /** Sets an entry of the state; the covariance stays. */
  void set(int entry, double value) {
    x[entry] = value;
    refresh();
  }
}
