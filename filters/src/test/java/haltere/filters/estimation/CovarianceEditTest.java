package haltere.filters.estimation;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.ejml.data.DMatrixRMaj;
import org.junit.jupiter.api.Test;

class CovarianceEditTest {
  private static final DMatrixRMaj P = new DMatrixRMaj(3, 3, true, 4, 1, 0, 1, 9, 0, 0, 0, 0);

  private static DMatrixRMaj edited(DMatrixRMaj p, int row, int column, double value) {
    GaussianState belief = new GaussianState(3);
    belief.set(new DMatrixRMaj(3, 1), p);
    belief.edit(row, column, value);
    return belief.covariance();
  }

  @Test
  void changedVarianceScalesItsCovariances() {
    assertArrayEquals(new double[] {16, 2, 0, 2, 9, 0, 0, 0, 0}, edited(P, 0, 0, 16).data, 1e-12);
    assertArrayEquals(new double[] {0, 0, 0, 0, 9, 0, 0, 0, 0}, edited(P, 0, 0, 0).data, 1e-12);
    assertArrayEquals(new double[] {4, 1, 0, 1, 9, 0, 0, 0, 5}, edited(P, 2, 2, 5).data, 1e-12);
  }

  @Test
  void changedCovarianceChangesItsCounterpart() {
    assertArrayEquals(
        new double[] {4, -5.9, 0, -5.9, 9, 0, 0, 0, 0}, edited(P, 1, 0, -5.9).data, 1e-12);
  }

  @Test
  void invalidCovariancesAreRejected() {
    assertThrows(IllegalArgumentException.class, () -> edited(P, 0, 0, -1));
    assertThrows(IllegalArgumentException.class, () -> edited(P, 0, 1, 6.1));
    assertThrows(IllegalArgumentException.class, () -> edited(P, 2, 0, 0.1));
    DMatrixRMaj three = new DMatrixRMaj(3, 3, true, 1, 0.9, 0.9, 0.9, 1, 0.9, 0.9, 0.9, 1);
    assertThrows(IllegalArgumentException.class, () -> edited(three, 0, 2, 0.5));
  }
}
