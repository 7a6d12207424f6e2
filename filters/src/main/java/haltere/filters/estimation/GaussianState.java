package haltere.filters.estimation;

import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.MatrixFeatures_DDRM;

/**
 * A Gaussian belief about a state: mean x and covariance P, with the operations of a Kalman filter
 * on them. Every estimator of Haltere keeps its covariance here. The covariance is symmetric to the
 * last bit after each operation.
 *
 * <pre>{@code
 * // edge of a wing: centre a, amplitude M, phase ξ, angular frequency ω; angle = a + M sin ξ
 * state.shear(2, 3, dtS);                               // ξ ← ξ + ω Δt
 * state.addNoise(3, density * dtS);
 * double expectedVariance = state.project(row);         // row: ∂angle/∂x
 * state.correct(angle - expected, measurementVariance);
 * }</pre>
 *
 * <p>A scalar correction is P ← P − g gᵀ/s with g = P h and s = hᵀ g + r. Where r is less than hᵀ P
 * h, digits cancel. The rounding errors are then taken out as Joseph's form does (Bucy and Joseph
 * 1968): exactly, P h = r K holds afterwards, so the smallest symmetric change that restores this
 * is applied (the symmetric secant update of Powell 1970). P stays positive definite for any ratio
 * of r to hᵀ P h.
 *
 * <p>Nothing is allocated after construction, but for vector corrections of a new size. Thread
 * rule: not safe for use by two threads at a time.
 */
public final class GaussianState {
  private final int n;
  private final DMatrixRMaj x;
  private final DMatrixRMaj p;
  private final DMatrixRMaj a;
  private final DMatrixRMaj ap;
  private final DMatrixRMaj kr = new DMatrixRMaj(1, 1);
  private final double[] g;
  private final double[] e;
  private double[] h = new double[0];
  private double projected = Double.NaN;

  /**
   * A state of zeros with a covariance of zeros.
   *
   * @param size number of entries, at least 1
   */
  public GaussianState(int size) {
    n = Require.atLeast("state size", 1, size);
    x = new DMatrixRMaj(n, 1);
    p = new DMatrixRMaj(n, n);
    a = new DMatrixRMaj(n, n);
    ap = new DMatrixRMaj(n, n);
    g = new double[n];
    e = new double[n];
  }

  /** {@return the number of entries of the state, at least 1} */
  public int size() {
    return n;
  }

  /** {@return the mean itself, n × 1, not a copy; the caller may write to it} */
  public DMatrixRMaj mean() {
    return x;
  }

  /** {@return the covariance itself, n × n, not a copy; it must be kept symmetric} */
  public DMatrixRMaj covariance() {
    return p;
  }

  /**
   * One entry of the mean.
   *
   * @param entry from 0
   * @return in its own unit
   */
  public double mean(int entry) {
    return x.data[entry];
  }

  /**
   * One entry of the covariance.
   *
   * @param row from 0
   * @param column from 0
   * @return in the product of both units
   */
  public double covariance(int row, int column) {
    return p.data[row * n + column];
  }

  /**
   * Standard deviation of an entry.
   *
   * @param entry from 0
   * @return at least 0, in the entry's unit
   */
  public double sd(int entry) {
    return Math.sqrt(Math.max(0, p.data[entry * n + entry]));
  }

  /**
   * Takes over mean and covariance.
   *
   * @param mean n × 1
   * @param covariance n × n; its symmetric part is taken
   */
  public void set(DMatrixRMaj mean, DMatrixRMaj covariance) {
    Require.size("state", mean, n, 1);
    Require.size("covariance", covariance, n, n);
    x.setTo(mean);
    p.setTo(covariance);
    symmetrise(p);
  }

  /**
   * Takes over another belief.
   *
   * @param other of the same size; not changed
   */
  public void set(GaussianState other) {
    System.arraycopy(other.x.data, 0, x.data, 0, n);
    System.arraycopy(other.p.data, 0, p.data, 0, n * n);
  }

  /**
   * Sets one entry of the mean.
   *
   * @param entry from 0
   * @param value in its own unit
   */
  public void setMean(int entry, double value) {
    x.data[entry] = value;
  }

  /**
   * Sets the covariance to a diagonal.
   *
   * @param variances n of them, not negative
   */
  public void setVariances(double... variances) {
    Arrays.fill(p.data, 0);
    for (int i = 0; i < n; i++) {
      p.data[i * n + i] = variances[i];
    }
  }

  /**
   * Predicts the covariance: P ← F P Fᵀ + Q. The mean is the caller's to evolve.
   *
   * @param f transition, n × n
   * @param q process noise of the step, n × n
   */
  public void predict(DMatrixRMaj f, DMatrixRMaj q) {
    transform(f);
    CommonOps_DDRM.addEquals(p, q);
    symmetrise(p);
  }

  /**
   * Transforms the covariance: P ← F P Fᵀ. The mean stays.
   *
   * @param f n × n
   */
  public void transform(DMatrixRMaj f) {
    CommonOps_DDRM.mult(f, p, ap);
    CommonOps_DDRM.multTransB(ap, f, p);
    symmetrise(p);
  }

  /**
   * Adds a multiple of one entry to another: x_i ← x_i + c x_j, with the covariance. A chain of
   * integrators is one call for each link, the highest entry of the chain last.
   *
   * @param i the entry that changes
   * @param j another entry
   * @param c factor, such as the time step
   */
  public void shear(int i, int j, double c) {
    x.data[i] += c * x.data[j];
    shearCovariance(i, j, c);
  }

  /**
   * {@link #shear} of the covariance alone, after the mean was predicted.
   *
   * @param i the entry that changes
   * @param j another entry
   * @param c factor, such as the time step
   */
  public void shearCovariance(int i, int j, double c) {
    double[] d = p.data;
    int rowI = i * n;
    int rowJ = j * n;
    double corner = d[rowI + i] + c * (2 * d[rowI + j] + c * d[rowJ + j]);
    for (int k = 0, column = i; k < n; k++, column += n) {
      double entry = d[rowI + k] + c * d[rowJ + k];
      d[rowI + k] = entry;
      d[column] = entry;
    }
    d[rowI + i] = corner;
  }

  /**
   * Multiplies the error of one entry: its row and column of P by a factor. The mean stays.
   *
   * @param i the entry
   * @param factor any
   */
  public void scale(int i, double factor) {
    double[] d = p.data;
    for (int k = 0; k < n; k++) {
      d[i * n + k] *= factor;
      d[k * n + i] *= factor;
    }
  }

  /**
   * Adds independent process noise to one entry.
   *
   * @param i the entry
   * @param variance that the step adds, not negative
   */
  public void addNoise(int i, double variance) {
    p.data[i * n + i] += variance;
  }

  /**
   * Adds correlated process noise to two entries.
   *
   * @param i one entry
   * @param j another entry
   * @param covariance that the step adds
   */
  public void addNoise(int i, int j, double covariance) {
    p.data[i * n + j] += covariance;
    p.data[j * n + i] += covariance;
  }

  /**
   * Adds the noise of a white acceleration (Bar-Shalom, Li and Kirubarajan, Estimation with
   * Applications to Tracking and Navigation, 2001, eq. 6.2.2-12) to a position and its velocity, or
   * the covariance of two such pairs.
   *
   * @param i entry of a position
   * @param k the same, or that of another position
   * @param density power spectral density of the acceleration, squared unit per s³
   * @param dtS length of the step, seconds
   */
  public void addAcceleration(int i, int k, double density, double dtS) {
    double vv = density * dtS;
    double pv = vv * dtS / 2;
    double pp = vv * dtS * dtS / 3;
    if (i == k) {
      addNoise(i, pp);
      addNoise(i + 1, vv);
    } else {
      addNoise(i, k, pp);
      addNoise(i + 1, k + 1, vv);
      addNoise(i + 1, k, pv);
    }
    addNoise(i, k + 1, pv);
  }

  /**
   * Lets an entry decay towards a value, as an Ornstein-Uhlenbeck process does.
   *
   * @param i the entry
   * @param towards stationary mean
   * @param share of the way, 0 to 1: 1 − exp(−Δt/τ)
   * @param sd stationary standard deviation
   */
  public void decay(int i, double towards, double share, double sd) {
    double keep = 1 - share;
    x.data[i] = towards + keep * (x.data[i] - towards);
    scale(i, keep);
    addNoise(i, (1 - keep * keep) * sd * sd);
  }

  /**
   * Projects the covariance onto a row: g = P h.
   *
   * @param row h, the Jacobian of a scalar measurement, n entries; must not change until {@link
   *     #correct(double, double)}
   * @return hᵀ P h, the variance of what the row measures
   */
  public double project(double[] row) {
    h = row;
    double[] d = p.data;
    double variance = 0;
    for (int i = 0, at = 0; i < n; i++, at += n) {
      double sum = 0;
      for (int j = 0; j < n; j++) {
        sum += d[at + j] * row[j];
      }
      g[i] = sum;
      variance += row[i] * sum;
    }
    projected = variance;
    return variance;
  }

  /**
   * Corrects by a scalar measurement of the row that was projected last.
   *
   * @param innovation y = z − h(x)
   * @param variance r of the measurement, positive
   * @return false, and nothing is changed, where a number is not finite or not positive
   */
  public boolean correct(double innovation, double variance) {
    double s = projected + variance;
    if (!(variance > 0 && s > 0 && Math.abs(innovation) * s < Double.POSITIVE_INFINITY)) {
      return false;
    }
    double perS = 1 / s;
    double[] d = p.data;
    double[] state = x.data;
    boolean cancels = projected > variance;
    double offRow = 0;
    for (int i = 0, at = 0; i < n; i++, at += n) {
      double gi = g[i];
      double gain = gi * perS;
      state[i] += gain * innovation;
      for (int j = 0; j < n; j++) {
        d[at + j] -= gi * g[j] * perS;
      }
      if (cancels) {
        double sum = -variance * gain;
        for (int j = 0; j < n; j++) {
          sum += d[at + j] * h[j];
        }
        e[i] = sum;
        offRow += h[i] * sum;
      }
    }
    if (cancels) {
      restore(offRow);
    }
    return true;
  }

  /** Restores P h = r K: P ← P − (w vᵀ + v wᵀ), v = g/(hᵀ g), w = e − ½ (hᵀ e) v. */
  private void restore(double offRow) {
    double[] d = p.data;
    double perProjected = 1 / projected;
    for (int i = 0; i < n; i++) {
      g[i] *= perProjected;
      e[i] -= 0.5 * offRow * g[i];
    }
    for (int i = 0, at = 0; i < n; i++, at += n) {
      double v = g[i];
      double w = e[i];
      for (int j = 0; j < n; j++) {
        d[at + j] -= w * g[j] + v * e[j];
      }
    }
  }

  /** Corrects by a vector measurement, in Joseph's form: P ← (I − K H) P (I − K H)ᵀ + K R Kᵀ. */
  void correct(Innovation in) {
    if (in.size() == 1) {
      project(in.h.data);
      correct(in.y.get(0), in.r.get(0));
      return;
    }
    CommonOps_DDRM.multAdd(in.gain, in.y, x);
    CommonOps_DDRM.mult(-1, in.gain, in.h, a);
    for (int i = 0; i < n; i++) {
      a.data[i * n + i] += 1;
    }
    kr.reshape(n, in.size());
    CommonOps_DDRM.mult(in.gain, in.r, kr);
    transform(a);
    CommonOps_DDRM.multAddTransB(kr, in.gain, p);
    symmetrise(p);
  }

  /**
   * Becomes the Gaussian of the mean and covariance of a mixture of Gaussians.
   *
   * @param parts of the same size, none of them this one
   * @param weights their weights, not negative, with the sum 1
   */
  public void mix(GaussianState[] parts, double[] weights) {
    Arrays.fill(x.data, 0);
    Arrays.fill(p.data, 0);
    for (int m = 0; m < parts.length; m++) {
      CommonOps_DDRM.addEquals(x, weights[m], parts[m].x);
    }
    for (int m = 0; m < parts.length; m++) {
      double weight = weights[m];
      if (weight == 0) {
        continue;
      }
      double[] from = parts[m].p.data;
      double[] mean = parts[m].x.data;
      for (int i = 0; i < n; i++) {
        double row = mean[i] - x.data[i];
        for (int j = 0; j < n; j++) {
          double spread = row * (mean[j] - x.data[j]);
          p.data[i * n + j] += weight * (from[i * n + j] + spread);
        }
      }
    }
  }

  /**
   * Sets one entry of the covariance, which remains valid; for users, not for the hot path. A new
   * variance scales its row and column, so that the correlations stay; a new covariance changes its
   * counterpart too.
   *
   * @param row from 0
   * @param column from 0
   * @param value the new number
   * @throws IllegalArgumentException if the covariance would be invalid
   */
  public void edit(int row, int column, double value) {
    if (row == column) {
      if (!(value >= 0)) {
        throw new IllegalArgumentException("a variance cannot be negative: " + value);
      }
      double before = p.get(row, row);
      scale(row, before > 0 ? Math.sqrt(value / before) : 0);
      p.set(row, row, value);
      return;
    }
    DMatrixRMaj edited = p.copy();
    edited.set(row, column, value);
    edited.set(column, row, value);
    if (!isCovariance(edited)) {
      throw new IllegalArgumentException(
          value + " is more than the variances of its row and its column allow");
    }
    p.setTo(edited);
  }

  /** Tests by Cholesky's decomposition of the correlations, with a tolerance for rounding. */
  private static boolean isCovariance(DMatrixRMaj p) {
    DMatrixRMaj correlations = p.createLike();
    for (int i = 0; i < p.numRows; i++) {
      for (int j = 0; j < p.numRows; j++) {
        double scale = Math.sqrt(p.get(i, i) * p.get(j, j));
        if (scale == 0 && i != j && p.get(i, j) != 0) {
          return false;
        }
        correlations.set(i, j, i == j ? 1 + 1e-9 : scale == 0 ? 0 : p.get(i, j) / scale);
      }
    }
    return MatrixFeatures_DDRM.isPositiveDefinite(correlations);
  }

  /** {@return whether all numbers are finite and no variance is negative} */
  public boolean isValid() {
    double sum = 0;
    for (int i = 0; i < n; i++) {
      if (!(p.data[i * n + i] >= 0)) {
        return false;
      }
      sum += x.data[i];
    }
    for (double entry : p.data) {
      sum += entry;
    }
    return Double.isFinite(sum);
  }

  /** Replaces a matrix by its symmetric part. */
  static void symmetrise(DMatrixRMaj m) {
    int size = m.numRows;
    for (int i = 1; i < size; i++) {
      for (int j = 0; j < i; j++) {
        double mean = 0.5 * (m.data[i * size + j] + m.data[j * size + i]);
        m.data[i * size + j] = mean;
        m.data[j * size + i] = mean;
      }
    }
  }
}
