package haltere.filters.orientation.internal.axis;

import haltere.filters.orientation.camera.RandomCameras;
import haltere.filters.orientation.camera.Vectors;
import java.util.SplittableRandom;

/** A point that moves on a sphere, computed with rotations (Rodrigues) only. */
public final class SpherePath {
  private double[] u;
  private double[] v;

  private SpherePath(double[] u, double[] v) {
    this.u = u;
    this.v = v;
  }

  static SpherePath random(SplittableRandom random, double rate) {
    double[] u = RandomCameras.unit(random);
    double[] v = Vectors.orthogonalTo(u);
    double[] other = new double[3];
    Vectors.cross(u, v, other);
    double a = rate * random.nextDouble(-1, 1);
    double b = rate * random.nextDouble(-1, 1);
    for (int k = 0; k < 3; k++) {
      v[k] = a * v[k] + b * other[k];
    }
    return new SpherePath(u, v);
  }

  static SpherePath of(AxisState state) {
    SpherePath path = new SpherePath(state.u().clone(), state.tipVelocity());
    path.e1 = state.e1().clone();
    path.e2 = state.e2().clone();
    return path;
  }

  private double[] e1;
  private double[] e2;

  /** Gives a filter this axis and, as far as it can know, this velocity. */
  void putInto(SphereFilter filter) {
    filter.launch(u, new double[] {1e-4, 0, 0, 0, 1e-4, 0, 0, 0, 1e-4});
    AxisHypothesis best = filter.hypotheses.get(0);
    best.error.setMean(1, Vectors.dot(v, best.e1));
    best.error.setMean(3, Vectors.dot(v, best.e2));
  }

  /** Moments of a filter over all hypotheses. */
  public static AxisState state(SphereFilter filter) {
    return filter.mixture.mean().state();
  }

  /**
   * State of the best hypothesis between prediction and update, with the noise of calm flight and
   * of saccades in it as likely as they are.
   */
  static AxisState predicted(SphereFilter filter) {
    AxisHypothesis best = filter.hypotheses.get(0);
    double wild = filter.nextSaccadeShare(best);
    double[] variances = filter.rateVariances;
    AxisHypothesis copy = new AxisHypothesis();
    copy.copy(best);
    copy.addNoise(filter.decay, (1 - wild) * variances[0] + wild * variances[variances.length - 1]);
    return copy.state();
  }

  double[] axis() {
    return u;
  }

  private static double[] rotated(double[] x, double[] about, double angle) {
    double[] unit = about.clone();
    if (angle == 0 || !Vectors.normalise(unit)) {
      return x.clone();
    }
    double[] across = new double[3];
    Vectors.cross(unit, x, across);
    double along = Vectors.dot(unit, x) * (1 - Math.cos(angle));
    double[] out = new double[3];
    for (int k = 0; k < 3; k++) {
      out[k] = x[k] * Math.cos(angle) + across[k] * Math.sin(angle) + unit[k] * along;
    }
    return out;
  }

  /** Moves to a neighbour: (a, ȧ, b, ḃ) along the state's own directions. */
  void displace(double[] error) {
    double[] step = new double[3];
    double[] rate = new double[3];
    for (int k = 0; k < 3; k++) {
      step[k] = error[0] * e1[k] + error[2] * e2[k];
      rate[k] = v[k] + error[1] * e1[k] + error[3] * e2[k];
    }
    double[] about = new double[3];
    Vectors.cross(u, step, about);
    double angle = Vectors.length(step);
    v = rotated(rate, about, angle);
    u = rotated(u, about, angle);
    e1 = rotated(e1, about, angle);
    e2 = rotated(e2, about, angle);
  }

  void step(double dtS, double tau) {
    double left = Math.exp(-dtS / tau);
    double[] about = new double[3];
    Vectors.cross(u, v, about);
    double angle = Vectors.length(v) * tau * (1 - left);
    u = rotated(u, about, angle);
    v = rotated(v, about, angle);
    if (e1 != null) {
      e1 = rotated(e1, about, angle);
      e2 = rotated(e2, about, angle);
    }
    for (int k = 0; k < 3; k++) {
      v[k] *= left;
    }
  }

  /** A frame beside the axis, where none was given. */
  void frame() {
    e1 = Vectors.orthogonalTo(u);
    e2 = new double[3];
    Vectors.cross(u, e1, e2);
  }

  /** By how much this is off from a state: (a, ȧ, b, ḃ) in the state's directions. */
  double[] errorFrom(AxisState state) {
    double[] about = new double[3];
    Vectors.cross(u, state.u(), about);
    double angle = Vectors.angle(u, state.u());
    double[] rate = rotated(v, about, angle);
    double along = Vectors.dot(u, state.u());
    double a = Vectors.dot(u, state.e1());
    double b = Vectors.dot(u, state.e2());
    double scale = angle < 1e-9 ? 1 : angle / Math.sin(angle);
    if (along < 0) {
      throw new IllegalArgumentException("on the other side");
    }
    return new double[] {
      a * scale,
      Vectors.dot(rate, state.e1()) - state.va(),
      b * scale,
      Vectors.dot(rate, state.e2()) - state.vb()
    };
  }
}
