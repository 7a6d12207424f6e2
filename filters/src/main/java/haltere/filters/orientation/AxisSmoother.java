package haltere.filters.orientation;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * Goes back over the steps of {@link SphereFilter} (Rauch, Tung and Striebel 1965) on the sphere:
 *
 * <pre>
 * C = P Fᵀ (P⁻)⁻¹     xˢ = x ⊞ C (xˢ₊ ⊟ x⁻)     Pˢ = P + C (Pˢ₊ − P⁻) Cᵀ
 * </pre>
 *
 * <p>⊞ and ⊟ are those of {@link SphereStates}. P⁻ holds the noise of calm flight and of saccades
 * as likely as each was.
 */
final class AxisSmoother {
  private AxisSmoother() {}

  /** A smoothed state for each step. */
  static List<AxisState> smooth(List<AxisStep> steps) {
    List<AxisState> smoothed = new ArrayList<>(steps.size());
    AxisState later = null;
    for (int k = steps.size() - 1; k >= 0; k--) {
      AxisStep next = k + 1 < steps.size() ? steps.get(k + 1) : null;
      boolean linked = next != null && next.predicted() != null && next.predicted().p() != null;
      later = linked ? back(steps.get(k).updated(), next, later) : steps.get(k).updated();
      smoothed.add(later);
    }
    Collections.reverse(smoothed);
    return smoothed;
  }

  private static AxisState back(AxisState at, AxisStep next, AxisState later) {
    DMatrixRMaj p = new DMatrixRMaj(4, 4, true, at.p().clone());
    DMatrixRMaj f = new DMatrixRMaj(4, 4, true, next.transition().clone());
    DMatrixRMaj predicted = new DMatrixRMaj(4, 4, true, next.predicted().p().clone());
    DMatrixRMaj inverse = predicted.copy();
    if (!CommonOps_DDRM.invert(inverse)) {
      return at;
    }
    DMatrixRMaj half = new DMatrixRMaj(4, 4);
    DMatrixRMaj gain = new DMatrixRMaj(4, 4);
    CommonOps_DDRM.multTransB(p, f, half);
    CommonOps_DDRM.mult(half, inverse, gain);
    DMatrixRMaj off = new DMatrixRMaj(4, 1, true, SphereStates.difference(later, next.predicted()));
    DMatrixRMaj error = new DMatrixRMaj(4, 1);
    CommonOps_DDRM.mult(gain, off, error);
    DMatrixRMaj change = new DMatrixRMaj(4, 4, true, later.p().clone());
    CommonOps_DDRM.subtractEquals(change, predicted);
    CommonOps_DDRM.mult(gain, change, half);
    CommonOps_DDRM.multAddTransB(half, gain, p);
    for (int i = 0; i < 4; i++) {
      for (int j = 0; j < i; j++) {
        double mean = 0.5 * (p.get(i, j) + p.get(j, i));
        p.set(i, j, mean);
        p.set(j, i, mean);
      }
    }
    boolean sound =
        Double.isFinite(error.get(0) + error.get(1) + error.get(2) + error.get(3))
            && p.get(0, 0) > 0
            && p.get(2, 2) > 0;
    return sound ? SphereStates.sum(at, error.getData(), p.getData()) : at;
  }
}
