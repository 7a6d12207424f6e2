package haltere.filters.estimation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ChiSquareTest {
  /** NIST/SEMATECH e-Handbook of Statistical Methods, section 1.3.6.7.4, three decimals. */
  @ParameterizedTest
  @CsvSource({
    "1, 0.90, 2.706",
    "1, 0.95, 3.841",
    "1, 0.975, 5.024",
    "1, 0.99, 6.635",
    "1, 0.999, 10.828",
    "2, 0.90, 4.605",
    "2, 0.95, 5.991",
    "2, 0.975, 7.378",
    "2, 0.99, 9.210",
    "2, 0.999, 13.816",
    "4, 0.95, 9.488",
    "5, 0.99, 15.086",
    "7, 0.95, 14.067",
    "10, 0.95, 18.307",
    "10, 0.05, 3.940",
    "10, 0.01, 2.558",
    "30, 0.975, 46.979",
    "30, 0.025, 16.791",
    "50, 0.05, 34.764",
    "100, 0.025, 74.222",
    "100, 0.975, 129.561",
    "3, 0.025, 0.216",
    "2, 0.01, 0.020",
    "1, 0.10, 0.016"
  })
  void quantilesAreThoseOfTheTables(double degrees, double probability, double tabulated) {
    assertEquals(tabulated, ChiSquare.quantile(probability, degrees), 5.01e-4);
  }

  /** Abramowitz and Stegun (1964), 26.4.5: an even number of degrees has a finite sum. */
  @ParameterizedTest
  @ValueSource(ints = {2, 4, 8, 20, 60, 200})
  void tailsOfEvenDegreesAreTheirFiniteSum(int degrees) {
    for (double x = 0.1 * degrees; x < 3 * degrees; x += 0.1 * degrees) {
      double term = Math.exp(-x / 2);
      double sum = term;
      for (int i = 1; i < degrees / 2; i++) {
        term *= x / 2 / i;
        sum += term;
      }
      assertEquals(sum, ChiSquare.exceedance(x, degrees), 1e-13 + 4e-13 * sum);
      assertEquals(1 - sum, ChiSquare.cumulative(x, degrees), 1e-12);
    }
  }

  @Test
  void twoDegreesAreAnExponential() {
    for (double p : new double[] {1e-12, 1e-3, 0.2, 0.5, 0.9, 0.999999}) {
      assertEquals(1, ChiSquare.quantile(p, 2) / (-2 * Math.log1p(-p)), 1e-12, "probability " + p);
      assertEquals(1, ChiSquare.quantileOfExceedance(p, 2) / (-2 * Math.log(p)), 1e-12);
    }
  }

  @Test
  void oneDegreeIsTheSquareOfANormalVariable() {
    // Normal quantiles: Abramowitz and Stegun (1964), table 26.5.
    assertEquals(1.959963984540054, Math.sqrt(ChiSquare.quantile(0.95, 1)), 1e-13);
    assertEquals(2.575829303548901, Math.sqrt(ChiSquare.quantile(0.99, 1)), 1e-13);
    assertEquals(0.6744897501960817, Math.sqrt(ChiSquare.quantile(0.5, 1)), 1e-13);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.5, 1, 2, 3, 7, 19, 100, 1_000, 40_000, 1_000_000})
  void theQuantileUndoesTheDistribution(double degrees) {
    for (double p : new double[] {1e-30, 1e-10, 1e-4, 0.025, 0.3, 0.5}) {
      double low = ChiSquare.quantile(p, degrees);
      assertEquals(1, ChiSquare.cumulative(low, degrees) / p, 2e-9, "lower tail " + p);
      double high = ChiSquare.quantileOfExceedance(p, degrees);
      assertEquals(1, ChiSquare.exceedance(high, degrees) / p, 2e-9, "upper tail " + p);
      assertTrue(low <= high || p > 0.4, "tails cross");
    }
  }

  @Test
  void theMiddleBandHasAsMuchBelowAsAbove() {
    Interval band = ChiSquare.band(0.95, 400);
    assertEquals(0.025, ChiSquare.cumulative(band.lower(), 400), 1e-12);
    assertEquals(0.025, ChiSquare.exceedance(band.upper(), 400), 1e-12);
    assertTrue(band.contains(400));
  }

  @Test
  void impossibleProbabilitiesAreRefused() {
    assertThrows(IllegalArgumentException.class, () -> ChiSquare.quantile(1, 2));
    assertThrows(IllegalArgumentException.class, () -> ChiSquare.quantile(Double.NaN, 2));
    assertThrows(IllegalArgumentException.class, () -> ChiSquare.quantileOfExceedance(0, 2));
    assertThrows(IllegalArgumentException.class, () -> ChiSquare.quantile(0.5, 0));
    assertThrows(IllegalArgumentException.class, () -> ChiSquare.band(1, 2));
    assertEquals(0, ChiSquare.quantile(0, 3));
    assertEquals(0, ChiSquare.quantileOfExceedance(1, 3));
  }
}
