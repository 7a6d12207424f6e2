package haltere.filters.orientation.internal.axis;

import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.Consistency;
import haltere.filters.estimation.Interval;
import haltere.filters.estimation.Whiteness;
import haltere.filters.orientation.AxisModels;
import haltere.filters.orientation.OrientationSettings;
import haltere.filters.orientation.camera.RandomCameras;
import haltere.filters.orientation.camera.Vectors;
import java.util.SplittableRandom;
import org.ejml.data.DMatrixRMaj;
import org.junit.jupiter.api.Test;

/** The filter is consistent on data of its own model. */
class AxisConsistencyTest {
  private static final int RUNS = 200;
  private static final int STEPS = 60;
  private static final double TAU_S = 0.1;

  @Test
  void meanNeesAndNisLieInTheirBandsForTheModel() {
    assertConsistent(2, 1, 6, 1000, RUNS);
  }

  @Test
  void meanNeesAndNisLieInTheirBandsForNonlinearAngles() {
    assertConsistent(5, 2, 4, 5000, 2 * RUNS);
  }

  private static void assertConsistent(
      double rate, double noiseDeg, int cameras, long firstSeed, int runs) {
    double sd = Math.toRadians(noiseDeg);
    OrientationSettings settings =
        OrientationSettings.defaults()
            .with(
                "gate.angleDeg=180",
                "turning.calmRateRadS=" + rate,
                "turning.saccadeRateRadS=" + rate,
                "turning.decayS=" + TAU_S);
    double nees = 0;
    double axisNees = 0;
    double nis = 0;
    int nisCount = 0;
    double[] whiteness = new double[runs];
    for (int run = 0; run < runs; run++) {
      SplittableRandom random = new SplittableRandom(firstSeed + run);
      LineMeasurement[] lines = new LineMeasurement[cameras];
      SpherePath truth = SpherePath.random(random, 0);
      for (int i = 0; i < lines.length; i++) {
        lines[i] = new LineMeasurement();
        RandomCameras.random(random).lineNormals(new double[3], lines[i].n);
        lines[i].varianceRad2 = sd * sd;
      }
      SphereFilter filter = new SphereFilter(AxisModels.of(settings));
      truth.frame();
      double[] off = {
        0.05 * random.nextGaussian(),
        rate * random.nextGaussian(),
        0.05 * random.nextGaussian(),
        rate * random.nextGaussian()
      };
      double[] start = truth.axis().clone();
      truth.displace(off);
      double[] covariance = new double[9];
      for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
          covariance[3 * i + j] = 0.0025 * ((i == j ? 1 : 0) - start[i] * start[j]);
        }
      }
      filter.launch(start, covariance);
      double[] series = new double[STEPS];
      for (int step = 0; step < STEPS; step++) {
        double dtS = random.nextDouble(0.002, 0.012);
        truth.step(dtS, TAU_S);
        truth.displace(noise(random, rate, dtS));
        filter.predict(dtS);
        for (LineMeasurement line : lines) {
          double vx = dot(line.n, 0, truth.axis());
          double vy = dot(line.n, 3, truth.axis());
          line.setAngle(Math.atan2(vy, vx) + sd * random.nextGaussian());
        }
        // Lines of one step share the error of the prediction, so one of them is looked at.
        LineMeasurement only = lines[step % lines.length];
        double innovation = normalised(only, SpherePath.predicted(filter));
        filter.update(lines, lines.length);
        nis += innovation * innovation;
        nisCount++;
        series[step] = innovation;
      }
      whiteness[run] = Whiteness.lagOneAutocorrelation(series);
      AxisState state = SpherePath.state(filter);
      double[] error = truth.errorFrom(state);
      nees += Consistency.nees(new DMatrixRMaj(4, 1, true, error), square(state.p(), 4));
      double[] axis = {error[0], error[2]};
      double[] p = {state.p()[0], state.p()[2], state.p()[2], state.p()[10]};
      axisNees += Consistency.nees(new DMatrixRMaj(2, 1, true, axis), square(p, 2));
    }
    assertIn(Consistency.meanBand(4, runs, 0.95), nees / runs, "NEES of axis and rates");
    assertIn(Consistency.meanBand(2, runs, 0.95), axisNees / runs, "NEES of the axis");
    assertIn(Consistency.meanBand(1, nisCount, 0.95), nis / nisCount, "NIS");
    double mean = java.util.Arrays.stream(whiteness).average().orElseThrow();
    assertIn(Whiteness.band(runs * STEPS, 0.95), mean, "autocorrelation");
  }

  /** Innovation over its standard deviation. */
  private static double normalised(LineMeasurement line, AxisState predicted) {
    double[] gradient = new double[3];
    line.gradient(predicted.u(), gradient);
    double ha = Vectors.dot(gradient, predicted.e1());
    double hb = Vectors.dot(gradient, predicted.e2());
    double[] p = predicted.p();
    double s = ha * ha * p[0] + 2 * ha * hb * p[2] + hb * hb * p[10] + line.varianceRad2;
    return line.residual(predicted.u()) / Math.sqrt(s);
  }

  private static void assertIn(Interval band, double value, String what) {
    assertTrue(
        value > band.lower() && value < band.upper(), what + " is " + value + ", band " + band);
  }

  private static DMatrixRMaj square(double[] entries, int size) {
    return new DMatrixRMaj(size, size, true, entries);
  }

  private static double dot(double[] n, int from, double[] u) {
    return n[from] * u[0] + n[from + 1] * u[1] + n[from + 2] * u[2];
  }

  /** A draw of what driven rates do in a step: Q's Cholesky factor, computed by quadrature. */
  private static double[] noise(SplittableRandom random, double size, double dtS) {
    int pieces = 200;
    double[] sum = new double[4];
    double position = 0;
    double both = 0;
    double rate = 0;
    for (int i = 0; i < pieces; i++) {
      double ago = dtS * (i + 0.5) / pieces;
      double left = Math.exp(-ago / TAU_S);
      double way = TAU_S * (1 - left);
      double density = 2 * size * size / TAU_S * dtS / pieces;
      position += density * way * way;
      both += density * way * left;
      rate += density * left * left;
    }
    double l00 = Math.sqrt(position);
    double l10 = both / l00;
    double l11 = Math.sqrt(rate - l10 * l10);
    for (int k = 0; k < 4; k += 2) {
      double first = random.nextGaussian();
      sum[k] = l00 * first;
      sum[k + 1] = l10 * first + l11 * random.nextGaussian();
    }
    return sum;
  }
}
