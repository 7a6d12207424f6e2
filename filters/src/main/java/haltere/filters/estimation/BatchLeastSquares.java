package haltere.filters.estimation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;

/**
 * The batch estimator of a process without noise: finds the first state whose trajectory fits all
 * measurements and the prior best. Unlike an extended Kalman filter, which keeps the effect of
 * early Jacobians, it linearises all measurements again about each improved trajectory.
 *
 * <pre>
 * minimise  J(x₀) = (x₀ − m)ᵀ P₀⁻¹ (x₀ − m) + Σ yₖᵀ R⁻¹ yₖ     yₖ = zₖ ⊖ h(xₖ)     xₖ = f(xₖ₋₁, Δt)
 * Λ = P₀⁻¹ + Σ (H Φₖ)ᵀ R⁻¹ H Φₖ     g = P₀⁻¹ (m − x₀) + Σ (H Φₖ)ᵀ R⁻¹ yₖ     Φₖ = Fₖ Φₖ₋₁
 * (Λ + λ diag Λ) δ = g              x₀ ← x₀ + δ where J falls, else a larger λ
 * </pre>
 *
 * <p>Tapley, Schutz and Born (2004), "Statistical Orbit Determination", section 4.6 (batch
 * processor with a priori information); Bell (1994), "The iterated Kalman smoother as a
 * Gauss-Newton method": without process noise that smoother is this estimator. λ: Marquardt (1963),
 * steps of ten as in Press et al., "Numerical Recipes", section 15.5. The covariances are inverses
 * of Λ, so they hold where the measurements leave one mode.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 */
public final class BatchLeastSquares {
  /** Steps shorter than a thousandth of a standard deviation, squared: gᵀ δ. */
  private static final double CONVERGED = 1e-6;

  private static final double FIRST_LAMBDA = 1e-3;
  private static final int MAX_STEPS = 100;

  private final ProcessModel process;
  private final MeasurementModel model;
  private final DMatrixRMaj mean;
  private final DMatrixRMaj information;
  private final List<Item> items = new ArrayList<>();

  /** A measurement and the time since the previous one. */
  private record Item(double dtS, DMatrixRMaj z) {}

  /**
   * The best fit.
   *
   * @param first state and covariance at the first measurement, time 0
   * @param last state and covariance at the last measurement
   * @param cost J; without the prior its mean is the number of measured values
   */
  public record Solution(Estimate first, Estimate last, double cost) {}

  /**
   * An estimator without measurements.
   *
   * @param process the process model; its noise is not used
   * @param model the measurement model; ungated
   * @param mean m, the prior mean of the first state; copied
   * @param covariance P₀ of that expectation, positive definite; copied
   */
  public BatchLeastSquares(
      ProcessModel process, MeasurementModel model, DMatrixRMaj mean, DMatrixRMaj covariance) {
    int n = process.stateSize();
    Require.state(mean, n);
    Require.covariance("covariance", covariance, n);
    this.process = process;
    this.model = model;
    this.mean = mean.copy();
    information = inverse(covariance);
  }

  /**
   * Adds a measurement after those added so far.
   *
   * @param dtS seconds since the last one, finite and not negative; of the first one, 0
   * @param z the measurement, finite
   */
  public void add(double dtS, double... z) {
    DMatrixRMaj column = new DMatrixRMaj(z.length, 1, true, z.clone());
    Require.size("measurement", column, model.size(), 1);
    Require.finite("measurement", column);
    items.add(new Item(Require.timeStep(dtS), column));
  }

  /**
   * Minimises J from a start, which selects one of several minima.
   *
   * @param start initial first state, not stored
   * @return empty if the trajectory from the start leaves the numbers, or Λ is singular to rounding
   */
  public Optional<Solution> fit(DMatrixRMaj start) {
    Require.state(start, process.stateSize());
    int n = process.stateSize();
    Trajectory best = new Trajectory(n);
    Trajectory tried = new Trajectory(n);
    DMatrixRMaj damped = new DMatrixRMaj(n, n);
    DMatrixRMaj delta = new DMatrixRMaj(n, 1);
    LinearSolverDense<DMatrixRMaj> solver = LinearSolverFactory_DDRM.chol(n);
    best.first.setTo(start);
    if (!best.follow(Double.MAX_VALUE)) {
      return Optional.empty();
    }
    double lambda = FIRST_LAMBDA;
    for (int step = 0; step < MAX_STEPS; step++) {
      damped.setTo(best.normal);
      for (int i = 0; i < n; i++) {
        damped.set(i, i, (1 + lambda) * best.normal.get(i, i));
      }
      boolean isBetter = false;
      if (solver.setA(damped)) {
        solver.solve(best.gradient, delta);
        if (CommonOps_DDRM.dot(best.gradient, delta) < CONVERGED) {
          break;
        }
        CommonOps_DDRM.add(best.first, delta, tried.first);
        isBetter = tried.follow(best.cost);
      }
      lambda = isBetter ? lambda / 10 : lambda * 10;
      if (isBetter) {
        Trajectory worse = best;
        best = tried;
        tried = worse;
      }
    }
    return best.solution();
  }

  /** The trajectory from a first state, with the normal equations Λ, g of its linearisation. */
  private final class Trajectory {
    final DMatrixRMaj first;
    final DMatrixRMaj normal;
    final DMatrixRMaj gradient;
    double cost;
    private final DMatrixRMaj x;
    private final DMatrixRMaj phi;

    Trajectory(int n) {
      first = new DMatrixRMaj(n, 1);
      normal = new DMatrixRMaj(n, n);
      gradient = new DMatrixRMaj(n, 1);
      x = new DMatrixRMaj(n, 1);
      phi = new DMatrixRMaj(n, n);
    }

    Optional<Solution> solution() {
      DMatrixRMaj p = phi.createLike();
      if (!CommonOps_DDRM.invertSPD(normal, p)) {
        return Optional.empty();
      }
      DMatrixRMaj phiP = phi.createLike();
      DMatrixRMaj lastP = phi.createLike();
      CommonOps_DDRM.mult(phi, p, phiP);
      CommonOps_DDRM.multTransB(phiP, phi, lastP);
      CommonOps_DDRM.symmLowerToFull(lastP);
      double timeS = items.stream().mapToDouble(Item::dtS).sum();
      return Optional.of(
          new Solution(
              new Estimate(0, ConstMatrix.copyOf(first), ConstMatrix.copyOf(p)),
              new Estimate(timeS, ConstMatrix.copyOf(x), ConstMatrix.copyOf(lastP)),
              cost));
    }

    /** Computes it; false as soon as J is not a number or above a limit. */
    boolean follow(double limit) {
      int n = first.numRows;
      int m = model.size();
      DMatrixRMaj evolved = new DMatrixRMaj(n, 1);
      DMatrixRMaj f = new DMatrixRMaj(n, n);
      DMatrixRMaj product = new DMatrixRMaj(n, n);
      DMatrixRMaj h = new DMatrixRMaj(m, n);
      DMatrixRMaj hPhi = new DMatrixRMaj(m, n);
      DMatrixRMaj weighted = new DMatrixRMaj(m, n);
      DMatrixRMaj r = new DMatrixRMaj(m, m);
      DMatrixRMaj expected = new DMatrixRMaj(m, 1);
      DMatrixRMaj y = new DMatrixRMaj(m, 1);
      CommonOps_DDRM.subtract(mean, first, x);
      CommonOps_DDRM.mult(information, x, gradient);
      cost = CommonOps_DDRM.dot(x, gradient);
      normal.setTo(information);
      CommonOps_DDRM.setIdentity(phi);
      x.setTo(first);
      for (Item item : items) {
        if (item.dtS() > 0) {
          process.jacobian(x, item.dtS(), f);
          CommonOps_DDRM.mult(f, phi, product);
          phi.setTo(product);
          process.evolve(x, item.dtS(), evolved);
          x.setTo(evolved);
        }
        model.expected(x, expected);
        model.residual(item.z(), expected, y);
        model.noise(x, r);
        DMatrixRMaj weight = inverse(r);
        CommonOps_DDRM.mult(weight, y, expected);
        cost += CommonOps_DDRM.dot(y, expected);
        if (!(cost <= limit)) {
          return false;
        }
        model.jacobian(x, h);
        CommonOps_DDRM.mult(h, phi, hPhi);
        CommonOps_DDRM.mult(weight, hPhi, weighted);
        CommonOps_DDRM.multAddTransA(hPhi, weighted, normal);
        CommonOps_DDRM.multAddTransA(hPhi, expected, gradient);
      }
      return true;
    }
  }

  /** Inverse of a positive definite matrix. */
  private static DMatrixRMaj inverse(DMatrixRMaj matrix) {
    DMatrixRMaj inverse = new DMatrixRMaj(matrix.numRows, matrix.numCols);
    CommonOps_DDRM.invertSPD(matrix, inverse);
    return inverse;
  }
}
