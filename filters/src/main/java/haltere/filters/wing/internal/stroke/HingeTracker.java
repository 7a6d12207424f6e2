package haltere.filters.wing.internal.stroke;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;

/**
 * Tracks the hinge of a wing as the body sways: a shift of the hinge makes residuals that differ
 * between near and far events. They are summed in normal equations of the shift and of centre,
 * amplitude and phase, which are eliminated (Schur complement). The shift is a random walk,
 * estimated every few milliseconds.
 */
final class HingeTracker {
  /** Index of the shift, after centre, amplitude and phase. */
  private static final int SHIFT = 3;

  /** Index of the right side, after the shift. */
  private static final int RIGHT = 5;

  /** Estimates from which the offset of a manual hinge is averaged. */
  private static final int OFFSET_SAMPLES = 10;

  /** Upper triangle of the normal equations with their right side. */
  private final DMatrixRMaj sums = new DMatrixRMaj(RIGHT + 1, RIGHT + 1);

  private final DMatrixRMaj p = new DMatrixRMaj(2, 2);
  private final DMatrixRMaj offsetSums = new DMatrixRMaj(3, 3);
  private int offsetSamples;
  private final LinearSolverDense<DMatrixRMaj> solver = LinearSolverFactory_DDRM.chol(SHIFT);
  private final DMatrixRMaj nuisances = new DMatrixRMaj(3, 3);
  private final DMatrixRMaj coupled = new DMatrixRMaj(3, 3);
  private final DMatrixRMaj taken = new DMatrixRMaj(3, 3);
  private final DMatrixRMaj seen = new DMatrixRMaj(3, 3);
  private final DMatrixRMaj information = new DMatrixRMaj(2, 2);
  private final DMatrixRMaj right = new DMatrixRMaj(2, 1);
  private final DMatrixRMaj effect = new DMatrixRMaj(3, 2);

  /** The last shift, pixels. */
  final DMatrixRMaj shift = new DMatrixRMaj(2, 1);

  /** Change of centre, amplitude and phase by the last shift. */
  final DMatrixRMaj stroke = new DMatrixRMaj(SHIFT, 1);

  /** Starts with a standard deviation of the hinge, pixels. */
  void launch(double sdPx) {
    CommonOps_DDRM.setIdentity(p);
    CommonOps_DDRM.scale(sdPx * sdPx, p);
    offsetSums.zero();
    offsetSamples = 0;
    sums.zero();
  }

  /**
   * Adds a residual.
   *
   * @param weight one over its variance
   * @param y the residual, radians
   * @param gx its decrease by a shift of the hinge to the right, radians a pixel
   * @param gy its decrease by a shift upwards, radians a pixel
   * @param sin sine of the phase
   * @param slope derivative of the angle with respect to the phase
   */
  void add(double weight, double y, double gx, double gy, double sin, double slope) {
    double[] d = sums.data;
    double wx = weight * gx;
    double wy = weight * gy;
    double ws = weight * sin;
    double wp = weight * slope;
    d[0] += weight;
    d[1] += ws;
    d[2] += wp;
    d[3] += wx;
    d[4] += wy;
    d[5] += weight * y;
    d[7] += ws * sin;
    d[8] += ws * slope;
    d[9] += ws * gx;
    d[10] += ws * gy;
    d[11] += ws * y;
    d[14] += wp * slope;
    d[15] += wp * gx;
    d[16] += wp * gy;
    d[17] += wp * y;
    d[21] += wx * gx;
    d[22] += wx * gy;
    d[23] += wx * y;
    d[28] += wy * gy;
    d[29] += wy * y;
  }

  /**
   * Estimates the shift since the last time; false if there is none.
   *
   * @param manual whether the hinge was set manually; its initial offset from the events is then
   *     subtracted from all shifts
   */
  boolean solve(double dtS, double walkPx2PerS, double inflation, boolean manual) {
    p.add(0, 0, walkPx2PerS * dtS);
    p.add(1, 1, walkPx2PerS * dtS);
    CommonOps_DDRM.symmUpperToFull(sums);
    CommonOps_DDRM.extract(sums, 0, SHIFT, 0, SHIFT, nuisances);
    CommonOps_DDRM.extract(sums, 0, SHIFT, SHIFT, RIGHT + 1, coupled);
    CommonOps_DDRM.extract(sums, SHIFT, RIGHT + 1, SHIFT, RIGHT + 1, seen);
    double trust = sums.get(0, 0) * 1e-6 + 1e-9;
    for (int i = 0; i < SHIFT; i++) {
      nuisances.add(i, i, trust);
    }
    sums.zero();
    if (!solver.setA(nuisances)) {
      return false;
    }
    solver.solve(coupled, taken);
    CommonOps_DDRM.multAddTransA(-1, coupled, taken, seen);
    CommonOps_DDRM.scale(1 / inflation, seen);
    if (manual && offsetSamples < OFFSET_SAMPLES) {
      offsetSamples++;
      CommonOps_DDRM.addEquals(offsetSums, seen);
      return false;
    }
    if (manual) {
      split(offsetSums);
      if (CommonOps_DDRM.det(information) > 0 && CommonOps_DDRM.invert(information)) {
        CommonOps_DDRM.mult(information, right, shift);
        split(seen);
        CommonOps_DDRM.multAdd(-1, information, shift, right);
        CommonOps_DDRM.insert(right, seen, 0, 2);
      }
    }
    split(seen);
    if (!(CommonOps_DDRM.det(p) > 0)) {
      return false;
    }
    CommonOps_DDRM.invert(p);
    CommonOps_DDRM.addEquals(p, information);
    CommonOps_DDRM.invert(p);
    CommonOps_DDRM.mult(p, right, shift);
    CommonOps_DDRM.extract(taken, 0, SHIFT, 0, 2, effect);
    CommonOps_DDRM.mult(-1, effect, shift, stroke);
    return true;
  }

  /** Splits the equations of a shift. */
  private void split(DMatrixRMaj equations) {
    CommonOps_DDRM.extract(equations, 0, 2, 0, 2, information);
    CommonOps_DDRM.extract(equations, 0, 2, 2, 3, right);
  }
}
