package haltere.filters.orientation;

import haltere.filters.orientation.camera.Vectors;
import java.util.Arrays;

/**
 * The source's form: body rates and a unit quaternion ({@link BodyQuaternion}). With {@link
 * TurningSettings#updateNoise} 0 a step is exact, q ⊗ exp(½ g ω), and its noise that of driven
 * rates; otherwise it is the source's: Euler's, with the same variance for all states at each
 * update. After each step and update the quaternion is made of length 1 and P projected.
 *
 * <p>The rotation about the axis is a state here although no camera sees it, so its variance grows.
 */
final class QuaternionFilter implements AxisFilter {
  private static final int N = 7;

  private final double rateVariance;
  private final double updateNoise;
  private final double gateRad;
  private final double outlierShare;

  private final double[] x = new double[N];
  private final double[] p = new double[N * N];
  private final double[] work = new double[N * N];
  private final double[] h = new double[N];
  private final double[] ph = new double[N];
  private final double[] prior = new double[N];
  private final double[] u = new double[3];
  private final double[] gradient = new double[3];
  private final double[] direction = new double[3];
  private final QuaternionMotion motion;
  private final AxisDoubt doubt = new AxisDoubt();
  private final AxisCandidate candidate;

  QuaternionFilter(OrientationSettings settings) {
    TurningSettings turning = settings.turning();
    double share =
        turning.saccadesPerS()
            * turning.saccadeS()
            / (1 + turning.saccadesPerS() * turning.saccadeS());
    rateVariance =
        (1 - share) * turning.calmRateRadS() * turning.calmRateRadS()
            + share * turning.saccadeRateRadS() * turning.saccadeRateRadS();
    updateNoise = turning.updateNoise();
    motion = new QuaternionMotion(turning.decayS(), rateVariance, updateNoise);
    candidate = new AxisCandidate(2 * settings.position().togetherS());
    gateRad = Math.toRadians(settings.gate().angleDeg());
    outlierShare = settings.gate().angleDeg() >= 90 ? 0 : settings.gate().outlierShare();
  }

  @Override
  public void launch(AxisLaunch found) {
    launch(found.axis(), found.covariance());
    doubt.reset(found.lines() > 2);
    candidate.forget();
  }

  /** Begins with an axis and its covariance in the world. */
  void launch(double[] axis, double[] covariance) {
    Arrays.fill(x, 0);
    Arrays.fill(p, 0);
    double[] y = Vectors.orthogonalTo(axis);
    double[] z = new double[3];
    Vectors.cross(axis, y, z);
    BodyQuaternion.set(x, axis, y, z);
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
            sum +=
                0.25
                    * BodyQuaternion.byRotation(x, i, k)
                    * rotation[k][l]
                    * BodyQuaternion.byRotation(x, j, l);
          }
        }
        p[(3 + i) * N + 3 + j] = sum;
      }
    }
    for (int i = 0; i < 3; i++) {
      p[i * N + i] = rateVariance;
    }
  }

  @Override
  public void predict(double dtS) {
    candidate.age(dtS);
    if (dtS == 0) {
      return;
    }
    motion.step(x, dtS);
    double[] f = motion.transition;
    double[] q = motion.noise;
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
      lines[i].ownRad2 = after(lines[i]);
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
          byAxis[0] * BodyQuaternion.axisByQuaternion(at, 0, j)
              + byAxis[1] * BodyQuaternion.axisByQuaternion(at, 1, j)
              + byAxis[2] * BodyQuaternion.axisByQuaternion(at, 2, j);
    }
  }

  /** A step of expectation and maximisation: R is the mean of ε² + H P⁺ Hᵀ. */
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

  /** The source does not. */
  @Override
  public void lean(double[] direction, double variance, double fresh) {}

  @Override
  public boolean doubts(LineMeasurement[] lines, int count) {
    return doubt.note(lines, count);
  }

  /** Two lines always have an axis in common, so one that replaces another is found twice. */
  @Override
  public boolean offer(AxisLaunch found) {
    boolean replaces = doubt.isEstablished();
    if (replaces && found.lines() == 2 && !candidate.isConfirmed(found.axis())) {
      return false;
    }
    launch(found.axis(), found.covariance());
    doubt.reset(found.lines() > 2 || replaces);
    return true;
  }

  @Override
  public double agreement() {
    return 1;
  }

  @Override
  public boolean isSettled() {
    return doubt.isCalm();
  }

  @Override
  public void tipVelocity(double[] out) {
    BodyQuaternion.tipVelocity(x, out);
  }

  /** The source smooths the axes themselves. */
  @Override
  public void record() {}

  @Override
  public AxisStep step() {
    return null;
  }

  @Override
  public AxisState state() {
    double[] now = new double[3];
    axis(now);
    return new AxisState(now, null, null, 0, 0, null);
  }

  @Override
  public void axis(double[] out) {
    BodyQuaternion.axis(x, out);
  }

  @Override
  public double axisVariance() {
    double sum = 0;
    for (int row = 0; row < 3; row++) {
      for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
          sum +=
              BodyQuaternion.axisByQuaternion(x, row, i)
                  * p[(3 + i) * N + 3 + j]
                  * BodyQuaternion.axisByQuaternion(x, row, j);
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
        sum +=
            4
                * BodyQuaternion.byRotation(x, i, 0)
                * p[(3 + i) * N + 3 + j]
                * BodyQuaternion.byRotation(x, j, 0);
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
}
