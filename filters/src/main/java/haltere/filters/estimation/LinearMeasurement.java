package haltere.filters.estimation;

import java.util.Objects;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/** A measurement z = H x + v with a constant H and R. */
public final class LinearMeasurement implements MeasurementModel {
  private final DMatrixRMaj h;
  private final DMatrixRMaj r;
  private final Gate gate;

  /**
   * A measurement by its matrices.
   *
   * @param h a row per measured number, a column per state; copied
   * @param r covariance of the noise, positive definite; copied
   * @param gate for innovations
   */
  public LinearMeasurement(DMatrixRMaj h, DMatrixRMaj r, Gate gate) {
    Require.finite("H", h);
    Require.covariance("R", r, h.numRows);
    this.h = h.copy();
    this.r = r.copy();
    this.gate = Objects.requireNonNull(gate, "gate");
  }

  /**
   * Measures entries of the state directly, each with the same independent noise.
   *
   * @param stateSize entries of the state
   * @param variance of each, in the square of the entry's unit, positive
   * @param entries which are measured, from 0
   * @return without a gate
   */
  public static LinearMeasurement ofEntries(int stateSize, double variance, int... entries) {
    Require.positive("measurement variance", variance);
    DMatrixRMaj h = new DMatrixRMaj(entries.length, stateSize);
    DMatrixRMaj r = new DMatrixRMaj(entries.length, entries.length);
    for (int i = 0; i < entries.length; i++) {
      h.set(i, entries[i], 1);
      r.set(i, i, variance);
    }
    return new LinearMeasurement(h, r, Gate.OPEN);
  }

  @Override
  public int size() {
    return h.numRows;
  }

  @Override
  public void expected(DMatrixRMaj x, DMatrixRMaj z) {
    CommonOps_DDRM.mult(h, x, z);
  }

  @Override
  public void jacobian(DMatrixRMaj x, DMatrixRMaj jacobian) {
    jacobian.setTo(h);
  }

  @Override
  public void noise(DMatrixRMaj x, DMatrixRMaj noise) {
    noise.setTo(r);
  }

  @Override
  public Gate gate() {
    return gate;
  }
}
