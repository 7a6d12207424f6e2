package haltere.filters.estimation;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * The extended Kalman filter as textbooks print it, with an inverse and a new matrix at each step:
 * the reference that the kernel is held against.
 */
final class Textbook {
  final DMatrixRMaj x;
  final DMatrixRMaj p;

  Textbook(DMatrixRMaj x, DMatrixRMaj p) {
    this.x = x.copy();
    this.p = p.copy();
  }

  void predict(ProcessModel model, double dtS) {
    int n = x.numRows;
    DMatrixRMaj f = new DMatrixRMaj(n, n);
    DMatrixRMaj q = new DMatrixRMaj(n, n);
    DMatrixRMaj next = new DMatrixRMaj(n, 1);
    model.jacobian(x, dtS, f);
    model.noise(x, dtS, q);
    model.evolve(x, dtS, next);
    x.setTo(next);
    p.setTo(Matrices.propagated(f, p, q));
  }

  void update(MeasurementModel model, DMatrixRMaj z) {
    int m = model.size();
    DMatrixRMaj h = new DMatrixRMaj(m, x.numRows);
    DMatrixRMaj r = new DMatrixRMaj(m, m);
    DMatrixRMaj expected = new DMatrixRMaj(m, 1);
    DMatrixRMaj y = new DMatrixRMaj(m, 1);
    model.jacobian(x, h);
    model.noise(x, r);
    model.expected(x, expected);
    model.residual(z, expected, y);
    update(h, y, r);
  }

  /** K = P H' S^-1, x + K y, (I - K H) P (I - K H)' + K R K'. */
  void update(DMatrixRMaj h, DMatrixRMaj y, DMatrixRMaj r) {
    DMatrixRMaj s = Matrices.propagated(h, p, r);
    CommonOps_DDRM.invert(s);
    DMatrixRMaj ph = new DMatrixRMaj(x.numRows, h.numRows);
    DMatrixRMaj gain = ph.copy();
    CommonOps_DDRM.multTransB(p, h, ph);
    CommonOps_DDRM.mult(ph, s, gain);
    CommonOps_DDRM.multAdd(gain, y, x);
    DMatrixRMaj a = CommonOps_DDRM.identity(x.numRows);
    CommonOps_DDRM.multAdd(-1, gain, h, a);
    DMatrixRMaj noise = Matrices.propagated(gain, r, new DMatrixRMaj(x.numRows, x.numRows));
    p.setTo(Matrices.propagated(a, p, noise));
  }
}
