package haltere.filters.estimation;

import static haltere.filters.estimation.Matrices.column;
import static haltere.filters.estimation.Matrices.diagonal;
import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.filters.estimation.motion.ConstantVelocity;
import haltere.testing.Allocation;
import org.ejml.data.DMatrixRMaj;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What runs for each event, or for each measurement, leaves nothing to be collected. */
class EstimationAllocationTest {
  private static final int STEPS = 500;

  @ParameterizedTest
  @EnumSource(CovarianceForm.class)
  void aClearFilterThatNobodyObservesAllocatesNothing(CovarianceForm form) {
    ConstantVelocity plane = new ConstantVelocity(2, 10);
    LinearMeasurement place = LinearMeasurement.ofEntries(4, 1, 0, 2);
    FilterOptions options = FilterOptions.DEFAULT.withForm(form);
    DMatrixRMaj x = column(0, 0, 0, 0);
    DMatrixRMaj p = diagonal(1, 1, 1, 1);
    KalmanFilter linear = new KalmanFilter(plane, x, p, options);
    ExtendedKalmanFilter extended = new ExtendedKalmanFilter(plane, x, p, options);
    DMatrixRMaj z = column(0.5, -0.5);
    assertEquals(
        0,
        Allocation.bytesOf(
            () -> {
              for (int k = 0; k < STEPS; k++) {
                linear.predict(0.01);
                linear.update(place, z);
                linear.updateOneByOne(place, z);
                extended.predict(0.01);
                extended.update(place, z);
              }
            }));
  }

  @Test
  void aFilterThatIsWrittenOutAllocatesNothing() {
    ConstantVelocityPlane plane = new ConstantVelocityPlane(10, Gate.sigmas(4), 20);
    plane.x().launch(0, 0, 1, 1);
    plane.y().launch(0, 0, 1, 1);
    FourStateEkf wing = new FourStateEkf(Gate.sigmas(4), 20);
    wing.setState(1.5, 1, 0, 1000);
    wing.setVariances(0.1, 0.1, 0.1, 100);
    assertEquals(
        0,
        Allocation.bytesOf(
            () -> {
              for (int k = 0; k < STEPS; k++) {
                plane.predict(0.01);
                plane.update(0.5, -0.5, 1, 1);
                wing.predict(0, 0, 0, 0, 0, 1e-5);
                wing.addNoise(1e-6, 1e-6, 1e-6, 1e-3);
                wing.update(0.1, 1, 0.5, 0.5, 0, 1);
              }
            }));
  }
}
