package haltere.filters.estimation;

import static haltere.filters.estimation.Matrices.column;
import static haltere.filters.estimation.Matrices.diagonal;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.ejml.data.DMatrixRMaj;
import org.junit.jupiter.api.Test;

class ConsistencyTest {
  @Test
  void errorIsNormalisedByItsCovariance() {
    assertEquals(1 + 4, Consistency.nees(column(2, 6), diagonal(4, 9)), 1e-14);
    DMatrixRMaj p = Matrices.rows(new double[] {2, 1}, new double[] {1, 2});
    // P⁻¹ = [2 −1; −1 2] / 3
    assertEquals((2 * 1 - 2 * 1 * 3 + 2 * 9) / 3.0, Consistency.nees(column(1, 3), p), 1e-14);
    assertThrows(
        IllegalArgumentException.class, () -> Consistency.nees(column(1, 1), diagonal(1, 0)));
  }

  @Test
  void meanNeesLiesInItsBandIn95PercentOfRuns() {
    Draws draws = new Draws(21);
    DMatrixRMaj p = draws.covariance(3);
    Interval band = Consistency.meanBand(3, 50, 0.95);
    int inside = 0;
    int trials = 1000;
    for (int t = 0; t < trials; t++) {
      double sum = 0;
      for (int k = 0; k < 50; k++) {
        sum += Consistency.nees(draws.normal(p), p);
      }
      inside += band.contains(sum / 50) ? 1 : 0;
    }
    assertEquals(0.95, inside / (double) trials, 4 * Math.sqrt(0.95 * 0.05 / trials));
  }

  @Test
  void onlyWhiteSeriesLieInTheWhitenessBand() {
    Draws draws = new Draws(22);
    double[] white = new double[500];
    double[] smooth = new double[500];
    Interval band = Whiteness.band(500, 0.95);
    int inside = 0;
    int trials = 1000;
    for (int t = 0; t < trials; t++) {
      for (int i = 0; i < white.length; i++) {
        white[i] = draws.normal(3);
        smooth[i] = i == 0 ? white[0] : 0.3 * smooth[i - 1] + white[i];
      }
      inside += band.contains(Whiteness.lagOneAutocorrelation(white)) ? 1 : 0;
      assertFalse(band.contains(Whiteness.lagOneAutocorrelation(smooth)));
    }
    assertEquals(0.95, inside / (double) trials, 4 * Math.sqrt(0.95 * 0.05 / trials));
    assertEquals(0, Whiteness.lagOneAutocorrelation(new double[5]));
    assertEquals(1, Whiteness.lagOneAutocorrelation(new double[] {2, 2, 2}), 1e-15);
    assertTrue(band.upper() > 0 && band.lower() == -band.upper());
  }
}
