package haltere.filters.estimation;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.decomposition.TriangularSolver_DDRM;

/** {@link CovarianceForm#UD}. */
final class UdCovariance implements CovarianceStore {
  private final int n;
  private final DMatrixRMaj u;
  private final double[] d;
  private final DMatrixRMaj noiseU;
  private final double[] weights;
  private final DMatrixRMaj w;
  private final DMatrixRMaj p;
  private final double[] f;
  private final double[] g;
  private final double[] b;
  private final double[] whiteRow;
  private final DMatrixRMaj whiteH = new DMatrixRMaj(1, 1);
  private final DMatrixRMaj whiteY = new DMatrixRMaj(1, 1);
  private final PositiveDefinite noise = new PositiveDefinite();
  private boolean current;

  UdCovariance(int size) {
    n = size;
    u = new DMatrixRMaj(n, n);
    d = new double[n];
    noiseU = new DMatrixRMaj(n, n);
    weights = new double[2 * n];
    w = new DMatrixRMaj(n, 2 * n);
    p = new DMatrixRMaj(n, n);
    f = new double[n];
    g = new double[n];
    b = new double[n];
    whiteRow = new double[n];
  }

  @Override
  public void set(DMatrixRMaj covariance) {
    UdFactors.of(covariance, u, d);
    current = false;
  }

  @Override
  public DMatrixRMaj matrix() {
    if (!current) {
      for (int i = 0; i < n; i++) {
        for (int j = i; j < n; j++) {
          double sum = 0;
          for (int k = j; k < n; k++) {
            sum += u.get(i, k) * d[k] * u.get(j, k);
          }
          p.set(i, j, sum);
          p.set(j, i, sum);
        }
      }
      current = true;
    }
    return p;
  }

  /** Thornton (1976): modified weighted Gram-Schmidt on the rows of [F U, G], Q = G Dq Gᵀ. */
  @Override
  public void predict(DMatrixRMaj transition, DMatrixRMaj q) {
    current = false;
    UdFactors.of(q, noiseU, f);
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < n; j++) {
        double sum = transition.get(i, j);
        for (int k = 0; k < j; k++) {
          sum += transition.get(i, k) * u.get(k, j);
        }
        w.set(i, j, sum);
        w.set(i, n + j, noiseU.get(i, j));
      }
      weights[i] = d[i];
      weights[n + i] = f[i];
    }
    for (int j = n - 1; j >= 0; j--) {
      double norm = 0;
      for (int k = 0; k < 2 * n; k++) {
        norm += w.get(j, k) * weights[k] * w.get(j, k);
      }
      d[j] = norm;
      for (int i = 0; i < j; i++) {
        double product = 0;
        for (int k = 0; k < 2 * n; k++) {
          product += w.get(i, k) * weights[k] * w.get(j, k);
        }
        double projection = norm > 0 ? product / norm : 0;
        u.set(i, j, projection);
        for (int k = 0; k < 2 * n; k++) {
          w.add(i, k, -projection * w.get(j, k));
        }
      }
    }
  }

  @Override
  public void correct(Innovation in, DMatrixRMaj stateChange) {
    current = false;
    stateChange.zero();
    int m = in.size();
    if (m == 1) {
      System.arraycopy(in.h.data, 0, whiteRow, 0, n);
      correctScalar(in.y.get(0), in.r.get(0), stateChange);
      return;
    }
    // R = L Lᵀ: L⁻¹ y and L⁻¹ H are independent scalars of variance 1.
    if (!noise.factor(in.r)) {
      throw new IllegalArgumentException("R is not positive definite");
    }
    whiteH.setTo(in.h);
    whiteY.setTo(in.y);
    TriangularSolver_DDRM.solveL(noise.lower().data, whiteY.data, m, 1);
    TriangularSolver_DDRM.solveL(noise.lower().data, whiteH.data, m, n);
    for (int i = 0; i < m; i++) {
      System.arraycopy(whiteH.data, i * n, whiteRow, 0, n);
      double innovation = whiteY.get(i);
      for (int j = 0; j < n; j++) {
        innovation -= whiteRow[j] * stateChange.get(j);
      }
      correctScalar(innovation, 1, stateChange);
    }
  }

  /** Bierman (1977), section V.3: one scalar of Jacobian {@link #whiteRow}. */
  private void correctScalar(double innovation, double r, DMatrixRMaj stateChange) {
    for (int j = 0; j < n; j++) {
      double sum = whiteRow[j];
      for (int i = 0; i < j; i++) {
        sum += u.get(i, j) * whiteRow[i];
      }
      f[j] = sum;
      g[j] = d[j] * sum;
    }
    double alpha = r;
    for (int j = 0; j < n; j++) {
      double before = alpha;
      alpha += f[j] * g[j];
      d[j] *= before / alpha;
      double lambda = -f[j] / before;
      b[j] = g[j];
      for (int i = 0; i < j; i++) {
        double entry = u.get(i, j);
        u.set(i, j, entry + lambda * b[i]);
        b[i] += entry * g[j];
      }
    }
    for (int i = 0; i < n; i++) {
      stateChange.add(i, 0, b[i] / alpha * innovation);
    }
  }
}
