package haltere.filters.estimation;

import static haltere.filters.estimation.Matrices.column;
import static haltere.filters.estimation.Matrices.covarianceOf;
import static haltere.filters.estimation.Matrices.diagonal;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.motion.ConstantVelocity;
import haltere.filters.estimation.motion.WhiteJerk;
import java.math.BigDecimal;
import java.math.MathContext;
import org.ejml.data.DMatrixRMaj;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class UdFormTest {
  @Test
  void theFactorsMakeTheMatrixAgainAndMayBeSingular() {
    Draws draws = new Draws(9);
    for (int n = 1; n <= 7; n++) {
      DMatrixRMaj p = draws.covariance(n);
      UdCovariance form = new UdCovariance(n);
      form.set(p);
      Matrices.assertSameCovariance(p, form.matrix(), 1e-13);
    }
    UdCovariance rankOne = new UdCovariance(2);
    DMatrixRMaj p = Matrices.rows(new double[] {4, 6}, new double[] {6, 9});
    rankOne.set(p);
    Matrices.assertClose(p, rankOne.matrix(), 1e-15);
  }

  /**
   * Bierman (1977), section V.5: prior I/ε², measurements x₁ + ε x₂ and x₁ + x₂ of variance 1. The
   * exact result from its information matrix, in 60 digits.
   */
  @ParameterizedTest
  @ValueSource(doubles = {1e-3, 1e-6, 1e-9, 1e-12, 1e-15})
  void itMatchesBiermansIllConditionedExampleToAllDigits(double epsilon) {
    KalmanFilter filter = biermans(epsilon, CovarianceForm.UD);
    DMatrixRMaj exact = exactBierman(epsilon);
    Matrices.assertSameCovariance(exact, covarianceOf(filter), 1e-13);
  }

  @Test
  void josephsFormLosesDigitsThereButNeverItsSign() {
    double epsilon = 1e-9;
    DMatrixRMaj exact = exactBierman(epsilon);
    DMatrixRMaj joseph = covarianceOf(biermans(epsilon, CovarianceForm.JOSEPH));
    DMatrixRMaj ud = covarianceOf(biermans(epsilon, CovarianceForm.UD));
    assertTrue(joseph.get(0, 0) > 0 && joseph.get(1, 1) > 0);
    double josephError = Math.abs(joseph.get(1, 1) / exact.get(1, 1) - 1);
    double udError = Math.abs(ud.get(1, 1) / exact.get(1, 1) - 1);
    assertTrue(josephError > 1e3 * udError, josephError + " against " + udError);
  }

  private static KalmanFilter biermans(double epsilon, CovarianceForm form) {
    double prior = 1 / (epsilon * epsilon);
    KalmanFilter filter =
        new KalmanFilter(
            new ConstantVelocity(1, 0),
            column(0, 0),
            diagonal(prior, prior),
            FilterOptions.DEFAULT.withForm(form));
    filter.update(measuring(1, epsilon), 0);
    filter.update(measuring(1, 1), 0);
    return filter;
  }

  private static LinearMeasurement measuring(double h0, double h1) {
    return new LinearMeasurement(new DMatrixRMaj(1, 2, true, h0, h1), diagonal(1), Gate.OPEN);
  }

  private static DMatrixRMaj exactBierman(double epsilon) {
    MathContext digits = new MathContext(60);
    BigDecimal e = new BigDecimal(epsilon);
    BigDecimal prior = BigDecimal.ONE.divide(new BigDecimal(1 / (epsilon * epsilon)), digits);
    BigDecimal i00 = prior.add(BigDecimal.valueOf(2));
    BigDecimal i01 = e.add(BigDecimal.ONE);
    BigDecimal i11 = prior.add(e.multiply(e)).add(BigDecimal.ONE);
    BigDecimal determinant = i00.multiply(i11).subtract(i01.multiply(i01));
    double p00 = i11.divide(determinant, digits).doubleValue();
    double p01 = -i01.divide(determinant, digits).doubleValue();
    double p11 = i00.divide(determinant, digits).doubleValue();
    return Matrices.rows(new double[] {p00, p01}, new double[] {p01, p11});
  }

  @Test
  void ofScalesThatLieTwentyPowersApartBothFormsTellTheSameAsLongAsTheyCan() {
    // Position in metres known to a nanometre, acceleration unknown to ten orders.
    DMatrixRMaj p0 = diagonal(1e-18, 1, 1e10);
    KalmanFilter ud =
        new KalmanFilter(
            new WhiteJerk(1, 1e-6),
            column(0, 0, 0),
            p0,
            FilterOptions.DEFAULT.withForm(CovarianceForm.UD));
    LinearMeasurement position = LinearMeasurement.ofEntries(3, 1e-18, 0);
    for (int k = 0; k < 200_000; k++) {
      ud.predict(1e-6);
      assertEquals(UpdateOutcome.APPLIED, ud.update(position, 0));
    }
    DMatrixRMaj p = covarianceOf(ud);
    for (int i = 0; i < 3; i++) {
      assertTrue(p.get(i, i) > 0);
    }
    assertTrue(ud.estimate().standardDeviation(2) < 1e-3, "the acceleration was found");
  }
}
