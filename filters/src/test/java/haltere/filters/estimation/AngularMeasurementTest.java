package haltere.filters.estimation;

import static haltere.filters.estimation.Matrices.column;
import static haltere.filters.estimation.Matrices.diagonal;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.FilterStep.Correction;
import haltere.filters.estimation.motion.AxisMotion;
import org.ejml.data.DMatrixRMaj;
import org.junit.jupiter.api.Test;

/** Angles wrap in the residual of a measurement. */
class AngularMeasurementTest {
  @Test
  void angularResidualTakesTheShortWay() {
    KalmanFilter filter =
        new KalmanFilter(
            new WingEdge(0, 0, 0, 0), column(3.1, 1, 0, 0), diagonal(0.1, 0.1, 0.1, 0.1));
    WingEdge.Angle angle = new WingEdge.Angle(0.01, Gate.sigmas(4));
    double[] nis = new double[1];
    filter.observe(step -> nis[0] = step instanceof Correction c ? c.nis() : Double.NaN);
    assertEquals(UpdateOutcome.APPLIED, filter.update(angle, -3.1));
    assertTrue(filter.state(0) > 3.1, "pulled over the seam, not around the circle");
    assertEquals(Math.pow(2 * Math.PI - 6.2, 2) / 0.21, nis[0], 1e-12);
  }

  @Test
  void filterFollowsAnAngleThroughManyTurns() {
    Draws draws = new Draws(4);
    KalmanFilter filter =
        new KalmanFilter(AxisMotion.constantVelocity(1, 0.1), column(0, 5), diagonal(1, 4));
    MeasurementModel heading = new Heading();
    double truth = 0;
    for (int k = 1; k <= 5000; k++) {
      truth += 7 * 0.02;
      filter.predict(0.02);
      UpdateOutcome outcome = filter.update(heading, Angles.wrapPi(truth + draws.normal(0.1)));
      assertEquals(UpdateOutcome.APPLIED, outcome);
    }
    assertEquals(0, Angles.wrapPi(filter.state(0) - truth), 0.1);
    assertEquals(7, filter.state(1), 0.2);
  }

  private static final class Heading implements MeasurementModel {
    @Override
    public int size() {
      return 1;
    }

    @Override
    public void expected(DMatrixRMaj x, DMatrixRMaj z) {
      z.set(0, 0, x.get(0));
    }

    @Override
    public void jacobian(DMatrixRMaj x, DMatrixRMaj h) {
      h.set(0, 0, 1);
      h.set(0, 1, 0);
    }

    @Override
    public void noise(DMatrixRMaj x, DMatrixRMaj r) {
      r.set(0, 0, 0.01);
    }

    @Override
    public void residual(DMatrixRMaj z, DMatrixRMaj expected, DMatrixRMaj y) {
      y.set(0, 0, Angles.wrapPi(z.get(0) - expected.get(0)));
    }
  }
}
