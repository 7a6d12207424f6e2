package haltere.filters.estimation;

import static haltere.filters.estimation.Matrices.column;
import static haltere.filters.estimation.Matrices.diagonal;
import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.filters.estimation.motion.AxisMotion;
import haltere.testing.Allocation;
import org.ejml.data.DMatrixRMaj;
import org.junit.jupiter.api.Test;

/** Updates per event or per measurement allocate no memory. */
class EstimationAllocationTest {
  private static final int STEPS = 500;

  @Test
  void unobservedFiltersAllocateNoMemory() {
    AxisMotion plane = AxisMotion.constantVelocity(2, 10);
    LinearMeasurement position = LinearMeasurement.ofEntries(4, 1, 0, 2);
    DMatrixRMaj x = column(0, 0, 0, 0);
    DMatrixRMaj p = diagonal(1, 1, 1, 1);
    KalmanFilter filter = new KalmanFilter(plane, x, p);
    DMatrixRMaj z = column(0.5, -0.5);
    assertEquals(
        0,
        Allocation.bytesOf(
            () -> {
              for (int k = 0; k < STEPS; k++) {
                filter.predict(0.01);
                filter.update(position, z);
              }
            }));
  }

  @Test
  void kernelAllocatesNoMemory() {
    GaussianState belief = new GaussianState(4);
    belief.setVariances(0.1, 0.1, 0.1, 100);
    double[] row = {1, 0.5, 0.5, 0};
    assertEquals(
        0,
        Allocation.bytesOf(
            () -> {
              for (int k = 0; k < STEPS; k++) {
                belief.shear(2, 3, 1e-5);
                belief.addNoise(3, 1e-3);
                belief.project(row);
                belief.correct(0.1, 1);
                belief.decay(0, 0, 0.1, 1);
              }
            }));
  }
}
