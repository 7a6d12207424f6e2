package haltere.filters.estimation;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * Goes back over the steps that a filter has recorded and gives each time the benefit of what came
 * after it.
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
   * @param steps all steps in order, as {@link GaussianFilter#observe} hands them out
   * @return an estimate for each time at which the filter stood: one at the beginning and one per
   *     prediction, in order
   */
  public static List<Estimate> smooth(List<? extends FilterStep> steps) {
    // Each stand: the filtered estimate at a time, and the prediction that leads to the next.
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
      // Nothing after a launch tells of the time before it.
      later = lead == null ? filtered.get(k) : back(filtered.get(k), lead, later);
      smoothed.add(later);
    }
    Collections.reverse(smoothed);
    return smoothed;
  }

  private static Estimate back(Estimate at, Prediction lead, Estimate later) {
    DMatrixRMaj p = at.covariance().toMatrix();
    DMatrixRMaj predicted = lead.estimate().covariance().toMatrix();
    DMatrixRMaj f = lead.transition().toMatrix();
    int n = p.numRows;
    PositiveDefinite factored = new PositiveDefinite();
    if (!factored.factor(predicted)) {
      throw new IllegalArgumentException(
          "predicted covariance at " + lead.estimate().timeS() + " s is not positive definite");
    }
    // P⁻ Cᵀ = F P
    DMatrixRMaj fp = new DMatrixRMaj(n, n);
    DMatrixRMaj gainTransposed = new DMatrixRMaj(n, n);
    CommonOps_DDRM.mult(f, p, fp);
    factored.solve(fp, gainTransposed);
    // xˢ = x + C (xˢ₊ − x⁻)
    DMatrixRMaj x = at.state().toMatrix();
    DMatrixRMaj stateChange = later.state().toMatrix();
    CommonOps_DDRM.subtractEquals(stateChange, lead.estimate().state().toMatrix());
    CommonOps_DDRM.multAddTransA(gainTransposed, stateChange, x);
    // Pˢ = P + C (Pˢ₊ − P⁻) Cᵀ
    DMatrixRMaj covarianceChange = later.covariance().toMatrix();
    CommonOps_DDRM.subtractEquals(covarianceChange, predicted);
    DMatrixRMaj half = new DMatrixRMaj(n, n);
    CommonOps_DDRM.multTransA(gainTransposed, covarianceChange, half);
    CommonOps_DDRM.multAdd(half, gainTransposed, p);
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < i; j++) {
        double mean = 0.5 * (p.get(i, j) + p.get(j, i));
        p.set(i, j, mean);
        p.set(j, i, mean);
      }
    }
    return new Estimate(at.timeS(), ConstMatrix.copyOf(x), ConstMatrix.copyOf(p));
  }
}
