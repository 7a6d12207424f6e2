package haltere.filters.estimation;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/** {@link CovarianceForm#JOSEPH}. */
final class JosephCovariance implements CovarianceStore {
  private final DMatrixRMaj p;
  private final DMatrixRMaj a;
  private final DMatrixRMaj ap;
  private final DMatrixRMaj kr = new DMatrixRMaj(1, 1);

  JosephCovariance(int size) {
    p = new DMatrixRMaj(size, size);
    a = new DMatrixRMaj(size, size);
    ap = new DMatrixRMaj(size, size);
  }

  @Override
  public void set(DMatrixRMaj covariance) {
    p.setTo(covariance);
    symmetrise();
  }

  @Override
  public DMatrixRMaj matrix() {
    return p;
  }

  @Override
  public void predict(DMatrixRMaj f, DMatrixRMaj q) {
    CommonOps_DDRM.mult(f, p, ap);
    CommonOps_DDRM.multTransB(ap, f, p);
    CommonOps_DDRM.addEquals(p, q);
    symmetrise();
  }

  @Override
  public void correct(Innovation in, DMatrixRMaj stateChange) {
    CommonOps_DDRM.mult(in.gain, in.y, stateChange);
    // A = I − K H
    CommonOps_DDRM.mult(-1, in.gain, in.h, a);
    for (int i = 0; i < a.numRows; i++) {
      a.add(i, i, 1);
    }
    // P ← A P Aᵀ + K R Kᵀ
    CommonOps_DDRM.mult(a, p, ap);
    CommonOps_DDRM.multTransB(ap, a, p);
    kr.reshape(in.gain.numRows, in.gain.numCols);
    CommonOps_DDRM.mult(in.gain, in.r, kr);
    CommonOps_DDRM.multAddTransB(kr, in.gain, p);
    symmetrise();
  }

  private void symmetrise() {
    int n = p.numRows;
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < i; j++) {
        double mean = 0.5 * (p.get(i, j) + p.get(j, i));
        p.set(i, j, mean);
        p.set(j, i, mean);
      }
    }
  }
}
