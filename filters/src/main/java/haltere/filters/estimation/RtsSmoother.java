package haltere.filters.estimation;

import haltere.filters.estimation.FilterStep.Launch;
import haltere.filters.estimation.FilterStep.Prediction;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.MatrixFeatures_DDRM;

/**
 * Rauch-Tung-Striebel smoother over the recorded steps of a filter: each estimate uses all
 * measurements.
 *
 * <pre>
 * C = P Fᵀ (P⁻)⁻¹     xˢ = x + C (xˢ₊ − x⁻)     Pˢ = P + C (Pˢ₊ − P⁻) Cᵀ
 * </pre>
 *
 * <p>Rauch, Tung and Striebel (1965); Bar-Shalom, Li and Kirubarajan (2001), eq. 8.6.2-13, -16,
 * -18. Of an extended filter it is the smoother of the linearised model.
 */
public final class RtsSmoother {
  private RtsSmoother() {}

  /**
   * Smooths.
   *
   * @param steps all steps in order, as from {@link KalmanFilter#observe}
   * @return an estimate for each time of the filter: one at the beginning and one per prediction,
   *     in order
   */
  public static List<Estimate> smooth(List<? extends FilterStep> steps) {
    // for each time: the filtered estimate, and the prediction of the next time
    List<Estimate> filtered = new ArrayList<>();
    List<Prediction> leads = new ArrayList<>();
    for (FilterStep step : steps) {
      if (step instanceof Prediction || step instanceof Launch || filtered.isEmpty()) {
        if (!filtered.isEmpty()) {
          leads.add(step instanceof Prediction p ? p : null);
        }
        filtered.add(step.estimate());
      } else {
        filtered.set(filtered.size() - 1, step.estimate());
      }
    }
    List<Estimate> smoothed = new ArrayList<>(filtered.size());
    Estimate later = null;
    for (int k = filtered.size() - 1; k >= 0; k--) {
      Prediction lead = k < leads.size() ? leads.get(k) : null;
      // a launch separates the times before and after it
      later = lead == null ? filtered.get(k) : smoothStep(filtered.get(k), lead, later);
      smoothed.add(later);
    }
    Collections.reverse(smoothed);
    return smoothed;
  }

  private static Estimate smoothStep(Estimate at, Prediction lead, Estimate later) {
    DMatrixRMaj p = at.covariance().toMatrix();
    DMatrixRMaj x = at.state().toMatrix();
    DMatrixRMaj change = later.state().toMatrix();
    CommonOps_DDRM.subtractEquals(change, lead.estimate().state().toMatrix());
    boolean done =
        smoothStep(
            p,
            lead.transition().toMatrix(),
            lead.estimate().covariance().toMatrix(),
            later.covariance().toMatrix(),
            change);
    if (!done) {
      throw new IllegalArgumentException(
          "predicted covariance at " + lead.estimate().timeS() + " s is not positive definite");
    }
    CommonOps_DDRM.addEquals(x, change);
    return new Estimate(at.timeS(), ConstMatrix.copyOf(x), ConstMatrix.copyOf(p));
  }

  /**
   * One step back, for states whose sums and differences are the caller's.
   *
   * @param p filtered covariance P; becomes Pˢ
   * @param f transition F of the prediction that followed
   * @param predicted P⁻, the covariance after that prediction
   * @param later Pˢ₊, the smoothed covariance at that time
   * @param change xˢ₊ − x⁻; becomes C (xˢ₊ − x⁻), the correction of the filtered state
   * @return false, and nothing is changed, where P⁻ is not positive definite
   */
  public static boolean smoothStep(
      DMatrixRMaj p, DMatrixRMaj f, DMatrixRMaj predicted, DMatrixRMaj later, DMatrixRMaj change) {
    if (!MatrixFeatures_DDRM.isPositiveDefinite(predicted)) {
      return false;
    }
    int n = p.numRows;
    DMatrixRMaj half = new DMatrixRMaj(n, n);
    DMatrixRMaj gainTransposed = new DMatrixRMaj(n, n);
    // P⁻ Cᵀ = F P
    CommonOps_DDRM.mult(f, p, half);
    CommonOps_DDRM.solveSPD(predicted, half, gainTransposed);
    DMatrixRMaj moved = new DMatrixRMaj(n, 1);
    CommonOps_DDRM.multTransA(gainTransposed, change, moved);
    change.setTo(moved);
    // P + C (Pˢ₊ − P⁻) Cᵀ
    DMatrixRMaj covarianceChange = later.copy();
    CommonOps_DDRM.subtractEquals(covarianceChange, predicted);
    CommonOps_DDRM.multTransA(gainTransposed, covarianceChange, half);
    CommonOps_DDRM.multAdd(half, gainTransposed, p);
    GaussianState.symmetrise(p);
    return true;
  }
}
