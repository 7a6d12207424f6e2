package haltere.filters.road;

import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.Consistency;
import haltere.filters.estimation.Interval;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.ejml.data.DMatrixRMaj;
import org.junit.jupiter.api.Test;

/** Errors of speeds and heights are consistent on vehicles of the model. */
class VehicleConsistencyTest {
  private static final int RUNS = 200;
  private static final double STEP_S = 0.01;
  private static final VehiclePrior PRIOR = VehiclePrior.defaults();

  /** Speed and the two heights. */
  private static final int[] JUDGED = {Vehicle.VY, Vehicle.LOW, Vehicle.MIDDLE};

  private final double[] squares = new double[JUDGED.length];
  private double nees;

  private void run(long seed, boolean isAway) {
    SeenVehicle.Errors errors = new SeenVehicle.Errors(seed, SeenVehicle.SD_PX);
    SplittableRandom random = new SplittableRandom(seed + 1000);
    double speed = 12 + 8 * random.nextDouble();
    SeenVehicle truth =
        new SeenVehicle(
            isAway ? 3 : -3,
            isAway ? 8 : 45,
            isAway ? speed : -speed,
            PRIOR.lowEdgeM() + PRIOR.lowEdgeM() * errors.gaussian(),
            (PRIOR.heightM() + 0.5 * PRIOR.heightM() * errors.gaussian()) / 2,
            (PRIOR.lengthM() + 0.5 * PRIOR.lengthM() * errors.gaussian()) / 2);
    Vehicle vehicle = new Vehicle(SeenVehicle.ROAD, PRIOR, 0);
    double q = 2 * PRIOR.accelerationMS2() * PRIOR.accelerationMS2() * Vehicle.LASTS_S;
    for (int step = 1; step < 150; step++) {
      double v = truth.vyMS() + Math.sqrt(q * STEP_S) * errors.gaussian();
      truth = truth.at(truth.yM() + 0.5 * (truth.vyMS() + v) * STEP_S, v);
      vehicle.update(truth.seen(step * 10_000L, STEP_S, errors));
    }
    double[] of = {truth.vyMS(), truth.lowM(), truth.middleM()};
    DMatrixRMaj error = new DMatrixRMaj(JUDGED.length, 1);
    DMatrixRMaj covariance = new DMatrixRMaj(JUDGED.length, JUDGED.length);
    for (int i = 0; i < JUDGED.length; i++) {
      error.set(i, vehicle.state().mean(JUDGED[i]) - of[i]);
      for (int j = 0; j < JUDGED.length; j++) {
        covariance.set(i, j, vehicle.state().covariance(JUDGED[i], JUDGED[j]));
      }
      squares[i] += error.get(i) * error.get(i) / covariance.get(i, i) / RUNS;
    }
    nees += Consistency.nees(error, covariance) / RUNS;
  }

  private void check(boolean isAway) {
    for (int run = 0; run < RUNS; run++) {
      run(run, isAway);
    }
    Interval band = Consistency.meanBand(JUDGED.length, RUNS, 0.99);
    String found = nees + " of " + band + "; speed, lower edge, middle " + Arrays.toString(squares);
    assertTrue(band.contains(nees), found);
  }

  @Test
  void approachingVehiclesAreConsistent() {
    check(false);
  }

  @Test
  void recedingVehiclesAreConsistent() {
    check(true);
  }
}
