package haltere.filters.orientation;

import haltere.filters.orientation.camera.Vectors;

/** Differences and sums of axes with their velocities: along great circles, frames not turning. */
final class SphereStates {
  private SphereStates() {}

  /** By how much a state is off from another: (a, ȧ, b, ḃ) in the other's directions. */
  static double[] difference(AxisState state, AxisState from) {
    double[] velocity = new double[3];
    for (int k = 0; k < 3; k++) {
      velocity[k] = state.va() * state.e1()[k] + state.vb() * state.e2()[k];
    }
    double[] about = new double[3];
    Vectors.cross(state.u(), from.u(), about);
    double angle = Vectors.angle(state.u(), from.u());
    double[] moved = rotated(velocity, about, angle);
    double scale = angle < 1e-7 ? 1 : angle / Math.sin(angle);
    return new double[] {
      scale * Vectors.dot(state.u(), from.e1()),
      Vectors.dot(moved, from.e1()) - from.va(),
      scale * Vectors.dot(state.u(), from.e2()),
      Vectors.dot(moved, from.e2()) - from.vb()
    };
  }

  /** A state that is off by an error, with a covariance. */
  static AxisState sum(AxisState state, double[] error, double[] covariance) {
    double[] step = new double[3];
    for (int k = 0; k < 3; k++) {
      step[k] = error[0] * state.e1()[k] + error[2] * state.e2()[k];
    }
    double[] about = new double[3];
    Vectors.cross(state.u(), step, about);
    double angle = Vectors.length(step);
    double[] u = rotated(state.u(), about, angle);
    Vectors.normalise(u);
    double[] e1 = rotated(state.e1(), about, angle);
    double along = Vectors.dot(e1, u);
    for (int k = 0; k < 3; k++) {
      e1[k] -= along * u[k];
    }
    Vectors.normalise(e1);
    double[] e2 = new double[3];
    Vectors.cross(u, e1, e2);
    return new AxisState(u, e1, e2, state.va() + error[1], state.vb() + error[3], covariance);
  }

  /** Rodrigues' rotation of a vector. */
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
}
