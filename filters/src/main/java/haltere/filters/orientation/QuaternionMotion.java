package haltere.filters.orientation;

import java.util.Arrays;

/**
 * A step of time of {@link BodyQuaternion}'s seven states, its derivative and its noise: exact, q ⊗
 * exp(½ g ω), with the noise of driven rates, or the source's, Euler's with the same variance for
 * all states. Reused.
 */
final class QuaternionMotion {
  private static final int N = 7;

  /** How errors go over the last step, 7 x 7. */
  final double[] transition = new double[N * N];

  /** Covariance that the last step added, 7 x 7. */
  final double[] noise = new double[N * N];

  private final double tau;
  private final double rateVariance;
  private final double updateNoise;
  private final RateDecay decay;
  private final double[] before = new double[4];
  private final double[] moved = new double[4];
  private final double[] rate = new double[N];

  /**
   * Motion.
   *
   * @param tau time constant of the rates, seconds
   * @param rateVariance of each rate
   * @param updateNoise variance that the source adds to all states at each step; 0 for exact steps
   */
  QuaternionMotion(double tau, double rateVariance, double updateNoise) {
    this.tau = tau;
    this.rateVariance = rateVariance;
    this.updateNoise = updateNoise;
    decay = new RateDecay(tau);
  }

  /** Moves the states by a time above 0. */
  void step(double[] x, double dtS) {
    Arrays.fill(transition, 0);
    Arrays.fill(noise, 0);
    if (updateNoise > 0) {
      eulerStep(x, dtS);
    } else {
      exactStep(x, dtS);
    }
  }

  /** x ← x + f Δt, F = I + Δt ∂f/∂x at a quaternion of length 1. */
  private void eulerStep(double[] x, double dtS) {
    BodyQuaternion.derivative(x, tau, rate);
    double half = 0.5 * dtS;
    for (int i = 0; i < N; i++) {
      transition[i * N + i] = 1;
      noise[i * N + i] = updateNoise;
    }
    for (int i = 0; i < 3; i++) {
      transition[i * N + i] -= dtS / tau;
    }
    for (int i = 0; i < 4; i++) {
      for (int j = 0; j < 3; j++) {
        transition[(3 + i) * N + j] = half * BodyQuaternion.byRotation(x, i, j);
      }
      for (int j = 0; j < 4; j++) {
        // The quotient's derivative: that of the numerator, and that of 1/n.
        transition[(3 + i) * N + 3 + j] +=
            half * BodyQuaternion.byRates(x, i, j) - dtS * rate[3 + i] * x[3 + j];
      }
    }
    for (int i = 0; i < N; i++) {
      x[i] += rate[i] * dtS;
    }
  }

  private void exactStep(double[] x, double dtS) {
    decay.step(dtS);
    double left = decay.left;
    double g = decay.reachS;
    double speed = Math.sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    double halfAngle = 0.5 * g * speed;
    double ratio = speed * g < 1e-8 ? 0.5 * g : Math.sin(halfAngle) / speed;
    double cos = Math.cos(halfAngle);
    double bend = speed * g < 1e-4 ? -g * g * g / 24 : (0.5 * g * cos - ratio) / (speed * speed);
    for (int i = 0; i < 3; i++) {
      transition[i * N + i] = left;
    }
    System.arraycopy(x, 3, before, 0, 4);
    for (int i = 0; i < 4; i++) {
      for (int j = 0; j < 3; j++) {
        double sum = 0;
        for (int k = 0; k < 3; k++) {
          double vector = (k == j ? ratio : 0) + bend * x[k] * x[j];
          sum += BodyQuaternion.byRotation(x, i, k) * vector;
        }
        transition[(3 + i) * N + j] = sum - before[i] * 0.5 * g * ratio * x[j];
      }
    }
    for (int i = 0; i < 4; i++) {
      for (int j = 0; j < 4; j++) {
        transition[(3 + i) * N + 3 + j] =
            (i == j ? cos : 0) + ratio * BodyQuaternion.byRates(x, i, j);
      }
    }
    for (int i = 0; i < 4; i++) {
      double sum = 0;
      for (int j = 0; j < 4; j++) {
        sum += transition[(3 + i) * N + 3 + j] * before[j];
      }
      moved[i] = sum;
    }
    for (int i = 0; i < 3; i++) {
      x[i] *= left;
    }
    System.arraycopy(moved, 0, x, 3, 4);
    addNoise(x);
  }

  /** The noise of driven rates, in the quaternion after the step. */
  private void addNoise(double[] x) {
    double place = rateVariance * decay.angleNoise;
    double both = rateVariance * decay.jointNoise;
    for (int i = 0; i < 3; i++) {
      noise[i * N + i] = rateVariance * decay.rateNoise;
    }
    for (int i = 0; i < 4; i++) {
      for (int j = 0; j < 3; j++) {
        noise[(3 + i) * N + j] = 0.5 * both * BodyQuaternion.byRotation(x, i, j);
        noise[j * N + 3 + i] = noise[(3 + i) * N + j];
      }
      for (int j = 0; j < 4; j++) {
        double sum = 0;
        for (int k = 0; k < 3; k++) {
          sum += BodyQuaternion.byRotation(x, i, k) * BodyQuaternion.byRotation(x, j, k);
        }
        noise[(3 + i) * N + 3 + j] = 0.25 * place * sum;
      }
    }
  }
}
