package haltere.filters.estimation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.junit.jupiter.api.Test;

/** The kernel matches the matrix equations. */
class GaussianStateTest {
  private static GaussianState drawn(Draws draws, int n) {
    GaussianState state = new GaussianState(n);
    state.set(draws.normal(CommonOps_DDRM.identity(n)), draws.covariance(n));
    return state;
  }

  @Test
  void shearIsATransitionWithOneOffDiagonalEntry() {
    Draws draws = new Draws(1);
    for (int run = 0; run < 100; run++) {
      int n = 2 + run % 9;
      GaussianState state = drawn(draws, n);
      DMatrixRMaj x = state.mean().copy();
      DMatrixRMaj p = state.covariance().copy();
      int i = run % n;
      int j = (i + 1 + run % (n - 1)) % n;
      DMatrixRMaj f = CommonOps_DDRM.identity(n);
      f.set(i, j, draws.normal(1));
      state.shear(i, j, f.get(i, j));
      DMatrixRMaj expected = new DMatrixRMaj(n, 1);
      CommonOps_DDRM.mult(f, x, expected);
      Matrices.assertClose(expected, state.mean(), 1e-12);
      Matrices.assertSameCovariance(
          Matrices.propagated(f, p, new DMatrixRMaj(n, n)), state.covariance(), 1e-12);
      assertSymmetric(state);
    }
  }

  @Test
  void scalarCorrectionsMatchTheTextbook() {
    Draws draws = new Draws(2);
    for (int run = 0; run < 100; run++) {
      int n = 1 + run % 11;
      GaussianState state = drawn(draws, n);
      Textbook textbook = new Textbook(state.mean(), state.covariance());
      for (int k = 0; k < 20; k++) {
        DMatrixRMaj h = new DMatrixRMaj(1, n);
        for (int i = 0; i < n; i++) {
          h.set(i, draws.normal(1));
        }
        double variance = Math.exp(draws.uniform(-5, 5));
        double innovation = draws.normal(1);
        DMatrixRMaj hph = Matrices.propagated(h, state.covariance(), new DMatrixRMaj(1, 1));
        assertEquals(hph.get(0), state.project(h.data), 1e-12 * (1 + hph.get(0)));
        assertTrue(state.correct(innovation, variance));
        textbook.update(h, Matrices.column(innovation), Matrices.column(variance));
        assertSymmetric(state);
      }
      Matrices.assertClose(textbook.x, state.mean(), 1e-9);
      Matrices.assertSameCovariance(textbook.p, state.covariance(), 1e-9);
    }
  }

  @Test
  void mixtureHasTheMomentsOfItsComponents() {
    GaussianState a = new GaussianState(2);
    a.set(Matrices.column(1, 0), Matrices.diagonal(1, 2));
    GaussianState b = new GaussianState(2);
    b.set(Matrices.column(3, 4), Matrices.diagonal(3, 4));
    GaussianState mixture = new GaussianState(2);
    mixture.mix(new GaussianState[] {a, b}, new double[] {0.25, 0.75});
    Matrices.assertClose(Matrices.column(2.5, 3), mixture.mean(), 1e-15);
    Matrices.assertClose(
        Matrices.rows(
            new double[] {2.5 + 0.1875 * 4, 0.1875 * 8},
            new double[] {0.1875 * 8, 3.5 + 0.1875 * 16}),
        mixture.covariance(),
        1e-15);
  }

  @Test
  void decayingStatesReturnToTheirStationaryMeanAndDeviation() {
    GaussianState state = new GaussianState(2);
    state.set(Matrices.column(5, 1), Matrices.rows(new double[] {9, 1}, new double[] {1, 4}));
    for (int k = 0; k < 400; k++) {
      state.decay(0, 2, 0.1, 0.5);
    }
    assertEquals(2, state.mean(0), 1e-12);
    assertEquals(0.25, state.covariance(0, 0), 1e-12);
    assertEquals(0, state.covariance(0, 1), 1e-12);
    assertEquals(1, state.mean(1));
    assertEquals(4, state.covariance(1, 1));
  }

  @Test
  void nonFiniteOrNonPositiveNumbersChangeNothing() {
    GaussianState state = drawn(new Draws(3), 3);
    DMatrixRMaj x = state.mean().copy();
    DMatrixRMaj p = state.covariance().copy();
    double[] row = {1, 0.5, -1};
    for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY}) {
      state.project(row);
      assertFalse(state.correct(bad, 1));
      assertFalse(state.correct(1, bad));
      state.project(new double[] {bad, 0, 0});
      assertFalse(state.correct(1, 1));
    }
    state.project(row);
    assertFalse(state.correct(1, 0));
    assertFalse(state.correct(1, -1));
    Matrices.assertClose(x, state.mean(), 0);
    Matrices.assertClose(p, state.covariance(), 0);
    assertTrue(state.isValid());
    state.setMean(0, Double.NaN);
    assertFalse(state.isValid());
    assertThrows(IllegalArgumentException.class, () -> new GaussianState(0));
    assertThrows(IllegalArgumentException.class, () -> state.set(Matrices.column(1, 2), p));
  }

  private static void assertSymmetric(GaussianState state) {
    for (int i = 0; i < state.size(); i++) {
      for (int j = 0; j < i; j++) {
        assertEquals(state.covariance(i, j), state.covariance(j, i));
      }
    }
  }
}
