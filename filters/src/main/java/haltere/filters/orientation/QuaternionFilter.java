package haltere.filters.orientation;

import java.util.Arrays;

/**
 * The source's form: body rates p, q, r and a unit quaternion (a, b, c, d), d its scalar part.
 *
 * <pre>
 * ṗ = −p/τ    q̇ = −q/τ    ṙ = −r/τ
 * ȧ = ( d p + b r − c q) / 2n      ḃ = ( d q + c p − a r) / 2n
 * ċ = ( d r + a q − b p) / 2n      ḋ = −(a p + b q + c r) / 2n,   n = |(a, b, c, d)|
 * u = (a² + d² − b² − c², 2(ab + cd), 2(ac − bd))
 * </pre>
 *
 * <p>The last derivative has the opposite sign before c r in the source, in print and in its code,
 * with which the length is not kept (Straw et al. 2011, documentation of the orientation filter).
 * With {@link TurningSettings#updateNoise} 0 a step is exact, q ⊗ exp(½ g ω), and its noise that of
 * driven rates; otherwise it is the source's: Euler's, with the same variance for all states at
 * each update. After each step and update the quaternion is made of length 1 and P projected.
 *
 * <p>The rotation about the axis is a state here although no camera sees it, so its variance grows.
 */
final class QuaternionFilter implements AxisFilter {
  private static final int N = 7;

  private final double tau;
  private final double rateVariance;
  private final double updateNoise;
  private final double gateRad;
  private final double outlierShare;

  private final double[] x = new double[N];
  private final double[] p = new double[N * N];
  private final double[] f = new double[N * N];
  private final double[] q = new double[N * N];
  private final double[] work = new double[N * N];
  private final double[] h = new double[N];
  private final double[] ph = new double[N];
  private final double[] prior = new double[N];
  private final double[] u = new double[3];
  private final double[] gradient = new double[3];
  private final double[] direction = new double[3];
  private final double[] turn = new double[4];

  QuaternionFilter(OrientationSettings settings) {
    TurningSettings turning = settings.turning();
    tau = turning.decayS();
    double share =
        turning.saccadesPerS()
            * turning.saccadeS()
            / (1 + turning.saccadesPerS() * turning.saccadeS());
    rateVariance =
        (1 - share) * turning.calmRateRadS() * turning.calmRateRadS()
            + share * turning.saccadeRateRadS() * turning.saccadeRateRadS();
    updateNoise = turning.updateNoise();
    gateRad = Math.toRadians(settings.gate().angleDeg());
    outlierShare = settings.gate().angleDeg() >= 90 ? 0 : settings.gate().outlierShare();
  }

  @Override
  public void launch(double[] axis, double[] covariance) {
    Arrays.fill(x, 0);
    Arrays.fill(p, 0);
    double[] y = Vectors.orthogonalTo(axis);
    double[] z = new double[3];
    Vectors.cross(axis, y, z);
    setQuaternion(axis, y, z);
    if (updateNoise > 0) {
      for (int i = 0; i < N; i++) {
        p[i * N + i] = i < 3 ? 0.5 : 1;
      }
      return;
    }
    // Rotations about y and z of the body move the axis along −z and y; that about x is unknown.
    double[] moved = new double[3];
    Vectors.multiply(covariance, y, moved);
    double yy = Vectors.dot(y, moved);
    double yz = Vectors.dot(z, moved);
    Vectors.multiply(covariance, z, moved);
    double zz = Vectors.dot(z, moved);
    double[][] rotation = {{Math.PI * Math.PI / 3, 0, 0}, {0, zz, -yz}, {0, -yz, yy}};
    for (int i = 0; i < 4; i++) {
      for (int j = 0; j < 4; j++) {
        double sum = 0;
        for (int k = 0; k < 3; k++) {
          for (int l = 0; l < 3; l++) {
            sum += 0.25 * byRotation(i, k) * rotation[k][l] * byRotation(j, l);
          }
        }
        p[(3 + i) * N + 3 + j] = sum;
      }
    }
    for (int i = 0; i < 3; i++) {
      p[i * N + i] = rateVariance;
    }
  }

  /** The quaternion of a rotation whose columns are given (Shepperd 1978). */
  private void setQuaternion(double[] c0, double[] c1, double[] c2) {
    double trace = c0[0] + c1[1] + c2[2];
    double[] squares = {
      1 + 2 * c0[0] - trace, 1 + 2 * c1[1] - trace, 1 + 2 * c2[2] - trace, 1 + trace
    };
    int largest = 0;
    for (int i = 1; i < 4; i++) {
      largest = squares[i] > squares[largest] ? i : largest;
    }
    double a;
    double b;
    double c;
    double d;
    switch (largest) {
      case 0 -> {
        a = squares[0];
        b = c1[0] + c0[1];
        c = c2[0] + c0[2];
        d = c1[2] - c2[1];
      }
      case 1 -> {
        a = c1[0] + c0[1];
        b = squares[1];
        c = c1[2] + c2[1];
        d = c2[0] - c0[2];
      }
      case 2 -> {
        a = c2[0] + c0[2];
        b = c1[2] + c2[1];
        c = squares[2];
        d = c0[1] - c1[0];
      }
      default -> {
        a = c1[2] - c2[1];
        b = c2[0] - c0[2];
        c = c0[1] - c1[0];
        d = squares[3];
      }
    }
    double n = Math.sqrt(a * a + b * b + c * c + d * d);
    x[3] = a / n;
    x[4] = b / n;
    x[5] = c / n;
    x[6] = d / n;
  }

  /**
   * Entry of the 4 x 3 matrix that takes a small body rotation to twice the quaternion's change.
   */
  private double byRotation(int row, int column) {
    double a = x[3];
    double b = x[4];
    double c = x[5];
    double d = x[6];
    return switch (3 * row + column) {
      case 0, 4, 8 -> d;
      case 1 -> -c;
      case 2 -> b;
      case 3 -> c;
      case 5 -> -a;
      case 6 -> -b;
      case 7 -> a;
      case 9 -> -a;
      case 10 -> -b;
      default -> -c;
    };
  }

  @Override
  public void predict(double dtS) {
    if (dtS == 0) {
      return;
    }
    Arrays.fill(f, 0);
    Arrays.fill(q, 0);
    if (updateNoise > 0) {
      eulerStep(dtS);
    } else {
      exactStep(dtS);
    }
    for (int i = 0; i < N; i++) {
      for (int j = 0; j < N; j++) {
        double sum = 0;
        for (int k = 0; k < N; k++) {
          sum += f[i * N + k] * p[k * N + j];
        }
        work[i * N + j] = sum;
      }
    }
    for (int i = 0; i < N; i++) {
      for (int j = 0; j < N; j++) {
        double sum = q[i * N + j];
        for (int k = 0; k < N; k++) {
          sum += work[i * N + k] * f[j * N + k];
        }
        p[i * N + j] = sum;
      }
    }
    normalise();
  }

  /** f(x) of the class comment into an array. */
  static void derivative(double[] x, double tau, double[] out) {
    double n = 2 * Math.sqrt(x[3] * x[3] + x[4] * x[4] + x[5] * x[5] + x[6] * x[6]);
    out[0] = -x[0] / tau;
    out[1] = -x[1] / tau;
    out[2] = -x[2] / tau;
    out[3] = (x[6] * x[0] + x[4] * x[2] - x[5] * x[1]) / n;
    out[4] = (x[6] * x[1] + x[5] * x[0] - x[3] * x[2]) / n;
    out[5] = (x[6] * x[2] + x[3] * x[1] - x[4] * x[0]) / n;
    out[6] = -(x[3] * x[0] + x[4] * x[1] + x[5] * x[2]) / n;
  }

  /** x ← x + f Δt, F = I + Δt ∂f/∂x at a quaternion of length 1. */
  private void eulerStep(double dtS) {
    double[] rate = new double[N];
    derivative(x, tau, rate);
    double half = 0.5 * dtS;
    for (int i = 0; i < N; i++) {
      f[i * N + i] = 1;
      q[i * N + i] = updateNoise;
    }
    for (int i = 0; i < 3; i++) {
      f[i * N + i] -= dtS / tau;
    }
    for (int i = 0; i < 4; i++) {
      for (int j = 0; j < 3; j++) {
        f[(3 + i) * N + j] = half * byRotation(i, j);
      }
      for (int j = 0; j < 4; j++) {
        // The quotient's derivative: that of the numerator, and that of 1/n.
        f[(3 + i) * N + 3 + j] += half * byQuaternion(i, j) - dtS * rate[3 + i] * x[3 + j];
      }
    }
    for (int i = 0; i < N; i++) {
      x[i] += rate[i] * dtS;
    }
  }

  /** Entry of the 4 x 4 matrix of rates that a quaternion is multiplied by. */
  private double byQuaternion(int row, int column) {
    double wp = x[0];
    double wq = x[1];
    double wr = x[2];
    return switch (4 * row + column) {
      case 1, 11 -> wr;
      case 2 -> -wq;
      case 3 -> wp;
      case 4 -> -wr;
      case 6 -> wp;
      case 7 -> wq;
      case 8 -> wq;
      case 9 -> -wp;
      case 12 -> -wp;
      case 13 -> -wq;
      case 14 -> -wr;
      default -> 0;
    };
  }

  private void exactStep(double dtS) {
    double s = dtS / tau;
    double gone = -Math.expm1(-s);
    double left = 1 - gone;
    double g = tau * gone;
    double speed = Math.sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    double halfAngle = 0.5 * g * speed;
    double ratio = speed * g < 1e-8 ? 0.5 * g : Math.sin(halfAngle) / speed;
    double cos = Math.cos(halfAngle);
    double bend = speed * g < 1e-4 ? -g * g * g / 24 : (0.5 * g * cos - ratio) / (speed * speed);
    for (int i = 0; i < 3; i++) {
      turn[i] = ratio * x[i];
      f[i * N + i] = left;
    }
    turn[3] = cos;
    double[] before = {x[3], x[4], x[5], x[6]};
    for (int i = 0; i < 4; i++) {
      for (int j = 0; j < 3; j++) {
        double sum = 0;
        for (int k = 0; k < 3; k++) {
          double vector = (k == j ? ratio : 0) + bend * x[k] * x[j];
          sum += byRotation(i, k) * vector;
        }
        f[(3 + i) * N + j] = sum - before[i] * 0.5 * g * ratio * x[j];
      }
    }
    double variance = rateVariance;
    double place = variance * tau * tau * placeNoise(s, gone);
    double both = variance * tau * gone * gone;
    for (int i = 0; i < 3; i++) {
      q[i * N + i] = variance * gone * (2 - gone);
    }
    for (int i = 0; i < 4; i++) {
      for (int j = 0; j < 4; j++) {
        f[(3 + i) * N + 3 + j] = (i == j ? cos : 0) + ratio * byQuaternion(i, j);
      }
    }
    for (int i = 0; i < 4; i++) {
      double sum = 0;
      for (int j = 0; j < 4; j++) {
        sum += f[(3 + i) * N + 3 + j] * before[j];
      }
      prior[i] = sum;
    }
    for (int i = 0; i < 3; i++) {
      x[i] *= left;
    }
    System.arraycopy(prior, 0, x, 3, 4);
    for (int i = 0; i < 4; i++) {
      for (int j = 0; j < 3; j++) {
        q[(3 + i) * N + j] = 0.5 * both * byRotation(i, j);
        q[j * N + 3 + i] = q[(3 + i) * N + j];
      }
      for (int j = 0; j < 4; j++) {
        double sum = 0;
        for (int k = 0; k < 3; k++) {
          sum += byRotation(i, k) * byRotation(j, k);
        }
        q[(3 + i) * N + 3 + j] = 0.25 * place * sum;
      }
    }
  }

  private static double placeNoise(double h, double gone) {
    return h > 0.05
        ? 2 * (h - gone) - gone * gone
        : h * h * h * (2.0 / 3 + h * (-0.5 + h * (7.0 / 30 - h / 12)));
  }

  /** Makes the quaternion of length 1 and takes that direction out of P. */
  private void normalise() {
    double n = Math.sqrt(x[3] * x[3] + x[4] * x[4] + x[5] * x[5] + x[6] * x[6]);
    for (int i = 3; i < N; i++) {
      x[i] /= n;
    }
    for (int side = 0; side < 2; side++) {
      for (int i = 0; i < N; i++) {
        double along = 0;
        for (int k = 3; k < N; k++) {
          along += x[k] * at(i, k, side);
        }
        for (int k = 3; k < N; k++) {
          int index = side == 0 ? i * N + k : k * N + i;
          p[index] = (p[index] - along * x[k]) / n;
        }
      }
    }
    for (int i = 0; i < N; i++) {
      for (int j = 0; j < i; j++) {
        double mean = 0.5 * (p[i * N + j] + p[j * N + i]);
        p[i * N + j] = mean;
        p[j * N + i] = mean;
      }
    }
  }

  private double at(int i, int k, int side) {
    return side == 0 ? p[i * N + k] : p[k * N + i];
  }

  @Override
  public void update(LineMeasurement[] lines, int count) {
    axis(u);
    System.arraycopy(x, 0, prior, 0, N);
    for (int i = 0; i < count; i++) {
      LineMeasurement line = lines[i];
      line.residualRad = line.residual(u);
      line.used = false;
      line.nis = Double.NaN;
      if (Math.abs(line.residualRad) < gateRad && line.gradient(u, gradient)) {
        takeIn(line);
      }
    }
    normalise();
    axis(direction);
    for (int i = 0; i < count; i++) {
      lines[i].afterRad2 = after(lines[i]);
    }
  }

  /** All lines are linearised at the prediction, so their order is nothing: one stacked update. */
  private void takeIn(LineMeasurement line) {
    setRow(prior, gradient);
    double y = line.residualRad;
    double s = line.varianceRad2;
    for (int i = 0; i < N; i++) {
      y -= h[i] * (x[i] - prior[i]);
      double sum = 0;
      for (int j = 0; j < N; j++) {
        sum += p[i * N + j] * h[j];
      }
      ph[i] = sum;
    }
    for (int i = 0; i < N; i++) {
      s += h[i] * ph[i];
    }
    if (!(s > 0) || Double.isInfinite(s)) {
      return;
    }
    double nis = y * y / s;
    double any = outlierShare / Math.PI * Math.sqrt(2 * Math.PI * s);
    if (outlierShare > 0 && (1 - outlierShare) * Math.exp(-0.5 * nis) < any) {
      return;
    }
    line.used = true;
    line.nis = nis;
    joseph(y / s, s, line.varianceRad2);
  }

  /** P ← A − (A h − R K) Kᵀ with A = P − K (P h)ᵀ, K = P h / S. */
  private void joseph(double step, double s, double r) {
    for (int i = 0; i < N; i++) {
      x[i] += ph[i] * step;
      for (int j = 0; j < N; j++) {
        work[i * N + j] = p[i * N + j] - ph[i] * ph[j] / s;
      }
    }
    for (int i = 0; i < N; i++) {
      double e = -r * ph[i] / s;
      for (int j = 0; j < N; j++) {
        e += work[i * N + j] * h[j];
      }
      for (int j = 0; j < N; j++) {
        p[i * N + j] = work[i * N + j] - e * ph[j] / s;
      }
    }
  }

  /** h = ∂θ/∂u ∂u/∂x. */
  private void setRow(double[] at, double[] byAxis) {
    h[0] = 0;
    h[1] = 0;
    h[2] = 0;
    for (int j = 0; j < 4; j++) {
      h[3 + j] =
          byAxis[0] * axisByQuaternion(at, 0, j)
              + byAxis[1] * axisByQuaternion(at, 1, j)
              + byAxis[2] * axisByQuaternion(at, 2, j);
    }
  }

  /** ∂u/∂(a, b, c, d), of a state. */
  static double axisByQuaternion(double[] state, int row, int column) {
    double a = 2 * state[3];
    double b = 2 * state[4];
    double c = 2 * state[5];
    double d = 2 * state[6];
    return switch (4 * row + column) {
      case 0 -> a;
      case 1 -> -b;
      case 2 -> -c;
      case 3 -> d;
      case 4 -> b;
      case 5 -> a;
      case 6 -> d;
      case 7 -> c;
      case 8 -> c;
      case 9 -> -d;
      case 10 -> a;
      default -> -b;
    };
  }

  private double after(LineMeasurement line) {
    if (!line.gradient(direction, gradient)) {
      return Double.NaN;
    }
    setRow(x, gradient);
    double y = line.residual(direction);
    double spread = 0;
    for (int i = 3; i < N; i++) {
      for (int j = 3; j < N; j++) {
        spread += h[i] * p[i * N + j] * h[j];
      }
    }
    return y * y + spread;
  }

  @Override
  public void axis(double[] out) {
    axis(x, out);
  }

  static void axis(double[] state, double[] out) {
    double a = state[3];
    double b = state[4];
    double c = state[5];
    double d = state[6];
    out[0] = a * a + d * d - b * b - c * c;
    out[1] = 2 * (a * b + c * d);
    out[2] = 2 * (a * c - b * d);
    Vectors.normalise(out);
  }

  @Override
  public void tipVelocity(double[] out) {
    double a = x[3];
    double b = x[4];
    double c = x[5];
    double d = x[6];
    double q = x[1];
    double r = x[2];
    out[0] = r * 2 * (a * b - c * d) - q * 2 * (a * c + b * d);
    out[1] = r * (b * b + d * d - a * a - c * c) - q * 2 * (b * c - a * d);
    out[2] = r * 2 * (b * c + a * d) - q * (c * c + d * d - a * a - b * b);
  }

  @Override
  public double axisVariance() {
    double sum = 0;
    for (int row = 0; row < 3; row++) {
      for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
          sum += axisByQuaternion(x, row, i) * p[(3 + i) * N + 3 + j] * axisByQuaternion(x, row, j);
        }
      }
    }
    return sum;
  }

  /**
   * The variance of roll should only grow, but P is linearised at a rate that changes, and so seems
   * to learn roll from what only tells the axis. That is no knowledge.
   */
  @Override
  public double rollSd() {
    double sum = 0;
    for (int i = 0; i < 4; i++) {
      for (int j = 0; j < 4; j++) {
        sum += 4 * byRotation(i, 0) * p[(3 + i) * N + 3 + j] * byRotation(j, 0);
      }
    }
    return Math.max(Math.PI / Math.sqrt(3), Math.sqrt(Math.max(0, sum)));
  }

  @Override
  public double rollRate() {
    return x[0];
  }

  @Override
  public boolean isSound() {
    double sum = 0;
    for (int i = 0; i < N; i++) {
      sum += x[i] + p[i * N + i];
    }
    return Double.isFinite(sum) && x[3] * x[3] + x[4] * x[4] + x[5] * x[5] + x[6] * x[6] > 0.5;
  }

  /** A copy of the seven states. */
  double[] state() {
    return x.clone();
  }
}
