package haltere.filters.orientation.internal.axis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.Angles;
import haltere.filters.orientation.AxisModels;
import haltere.filters.orientation.OrientationSettings;
import haltere.filters.orientation.camera.RandomCameras;
import haltere.filters.orientation.camera.Vectors;
import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

class AxisFilterTest {
  private static LineMeasurement line(SplittableRandom random) {
    LineMeasurement line = new LineMeasurement();
    double[] at = {random.nextDouble(-0.1, 0.1), random.nextDouble(-0.1, 0.1), 0.05};
    assertTrue(RandomCameras.random(random).lineNormals(at, line.n));
    line.setAngle(random.nextDouble(-1.5, 1.5));
    line.varianceRad2 = Math.toRadians(2) * Math.toRadians(2);
    return line;
  }

  private static AxisFilter launched(
      OrientationSettings settings, double[] axis, double[] covariance) {
    if (settings.form() == OrientationSettings.Form.QUATERNION) {
      QuaternionFilter filter = new QuaternionFilter(AxisModels.of(settings));
      filter.launch(axis, covariance);
      return filter;
    }
    SphereFilter filter = new SphereFilter(AxisModels.of(settings));
    filter.launch(axis, covariance);
    return filter;
  }

  private static double angle(LineMeasurement line, double[] u) {
    double vx = line.n[0] * u[0] + line.n[1] * u[1] + line.n[2] * u[2];
    double vy = line.n[3] * u[0] + line.n[4] * u[1] + line.n[5] * u[2];
    return Math.atan2(vy, vx);
  }

  @Test
  void gradientOfAnAngleMatchesDifferences() {
    SplittableRandom random = new SplittableRandom(1);
    double[] gradient = new double[3];
    int compared = 0;
    for (int i = 0; i < 500; i++) {
      LineMeasurement line = line(random);
      double[] u = RandomCameras.unit(random);
      line.gradient(u, gradient);
      if (Vectors.length(gradient) > 3) {
        continue; // seen end-on, where differences are no measure
      }
      for (int k = 0; k < 3; k++) {
        int entry = k;
        double difference =
            difference(
                step -> {
                  double[] moved = u.clone();
                  moved[entry] += step;
                  return Angles.wrapHalfPi(angle(line, moved) - angle(line, u));
                },
                2e-3);
        assertEquals(difference, gradient[k], 1e-9 * (1 + Math.abs(difference)));
      }
      assertEquals(0, Vectors.dot(gradient, u), 1e-12, "a longer axis looks the same");
      compared++;
    }
    assertTrue(compared > 200, compared + " compared");
  }

  /**
   * The derivative at 0 by differences of the fourth order at two steps, extrapolated to the sixth
   * (Richardson): exact to about 1e-11 where a few thousandths are a small step.
   */
  private static double difference(DoubleUnaryOperator f, double step) {
    return (16 * fourthOrder(f, step / 2) - fourthOrder(f, step)) / 15;
  }

  private static double fourthOrder(DoubleUnaryOperator f, double h) {
    double near = f.applyAsDouble(h) - f.applyAsDouble(-h);
    double far = f.applyAsDouble(2 * h) - f.applyAsDouble(-2 * h);
    return (8 * near - far) / (12 * h);
  }

  @Test
  void secondOrderTermsMatchDifferencesOfTheGradient() {
    SplittableRandom random = new SplittableRandom(8);
    int compared = 0;
    for (int i = 0; i < 300; i++) {
      LineMeasurement line = line(random);
      AxisHypothesis hypothesis = new AxisHypothesis();
      double[] u = RandomCameras.unit(random);
      double[] p = new double[9];
      for (int k = 0; k < 3; k++) {
        double[] v = RandomCameras.unit(random);
        for (int e = 0; e < 9; e++) {
          p[e] += 0.02 * v[e / 3] * v[e % 3];
        }
      }
      hypothesis.launch(u, p, 1);
      hypothesis.expect(0);
      LineComparison seen = new LineComparison();
      if (!seen.compare(hypothesis, line) || Math.hypot(seen.ha, seen.hb) > 3) {
        continue;
      }
      double[][] second = new double[2][];
      for (int k = 0; k < 2; k++) {
        int entry = k;
        second[k] =
            new double[] {
              difference(step -> gradientAt(hypothesis, line, entry, step)[0], 2e-3),
              difference(step -> gradientAt(hypothesis, line, entry, step)[1], 2e-3)
            };
      }
      hypothesis.error.mean().zero();
      seen.compare(hypothesis, line);
      double[] covariance = hypothesis.error.covariance().data;
      double[] half = {covariance[0], covariance[2], covariance[2], covariance[10]};
      double trace = 0;
      double square = 0;
      for (int a = 0; a < 2; a++) {
        for (int b = 0; b < 2; b++) {
          trace += second[a][b] * half[2 * b + a];
          for (int c = 0; c < 2; c++) {
            for (int d = 0; d < 2; d++) {
              square += second[a][b] * half[2 * b + c] * second[c][d] * half[2 * d + a];
            }
          }
        }
      }
      assertEquals(line.residual(hypothesis.u) - 0.5 * trace, seen.innovation, 1e-9);
      assertEquals(line.varianceRad2 + 0.5 * square, seen.noise, 1e-9);
      compared++;
    }
    assertTrue(compared > 100, compared + " compared");
  }

  private static double[] gradientAt(
      AxisHypothesis hypothesis, LineMeasurement line, int entry, double step) {
    hypothesis.error.mean().zero();
    hypothesis.error.setMean(2 * entry, step);
    LineComparison seen = new LineComparison();
    seen.compare(hypothesis, line);
    return new double[] {seen.ha, seen.hb};
  }

  @Test
  void gradientByTheQuaternionMatchesDifferences() {
    SplittableRandom random = new SplittableRandom(2);
    double[] gradient = new double[3];
    double[] u = new double[3];
    for (int i = 0; i < 300; i++) {
      double[] x = state(random);
      LineMeasurement line = line(random);
      BodyQuaternion.axis(x, u);
      line.gradient(u, gradient);
      if (Vectors.length(gradient) > 3) {
        continue;
      }
      for (int j = 0; j < 4; j++) {
        double analytic = 0;
        for (int row = 0; row < 3; row++) {
          analytic += gradient[row] * BodyQuaternion.axisByQuaternion(x).get(row, j);
        }
        int entry = j;
        double difference = difference(step -> at(line, x, entry, step), 2e-3);
        assertEquals(difference, analytic, 1e-9 * (1 + Math.abs(analytic)));
      }
      double radial = 0;
      double[] roll = {x[6], x[5], -x[4], -x[3]};
      double aboutAxis = 0;
      for (int j = 0; j < 4; j++) {
        double sum = 0;
        for (int row = 0; row < 3; row++) {
          sum += gradient[row] * BodyQuaternion.axisByQuaternion(x).get(row, j);
        }
        radial += sum * x[3 + j];
        aboutAxis += sum * roll[j];
      }
      assertEquals(0, radial, 1e-12, "the length of a quaternion is not seen");
      assertEquals(0, aboutAxis, 1e-12, "roll is not seen");
    }
  }

  /** Angle at a changed quaternion, near that at the unchanged one. */
  private static double at(LineMeasurement line, double[] x, int j, double step) {
    double[] u = new double[3];
    BodyQuaternion.axis(x, u);
    double before = angle(line, u);
    double[] moved = x.clone();
    moved[3 + j] += step;
    BodyQuaternion.axis(moved, u);
    return before + Angles.wrapHalfPi(angle(line, u) - before);
  }

  private static double[] state(SplittableRandom random) {
    double[] x = new double[7];
    double n = 0;
    for (int i = 0; i < 7; i++) {
      x[i] = random.nextDouble(-1, 1) * (i < 3 ? 20 : 1);
      n += i < 3 ? 0 : x[i] * x[i];
    }
    for (int i = 3; i < 7; i++) {
      x[i] /= Math.sqrt(n);
    }
    return x;
  }

  @Test
  void derivativeOfTheQuaternionPreservesItsLength() {
    SplittableRandom random = new SplittableRandom(3);
    for (int i = 0; i < 100; i++) {
      double[] x = state(random);
      double[] rate = BodyQuaternion.derivative(x, 0.1);
      double along = x[3] * rate[3] + x[4] * rate[4] + x[5] * rate[5] + x[6] * rate[6];
      assertEquals(0, along, 1e-13);
    }
  }

  @Test
  void transitionMatchesNeighbouringPathsOnTheSphere() {
    SplittableRandom random = new SplittableRandom(4);
    for (int i = 0; i < 50; i++) {
      double dtS = random.nextDouble(1e-4, 0.03);
      SpherePath start = SpherePath.random(random, 25);
      SphereFilter filter = new SphereFilter(AxisModels.of(OrientationSettings.defaults()));
      start.putInto(filter);
      AxisState before = SpherePath.state(filter);
      filter.predict(dtS);
      double[] transition = filter.hypotheses.get(0).transition.data.clone();
      AxisState after = SpherePath.predicted(filter);
      for (int column = 0; column < 4; column++) {
        for (int row = 0; row < 4; row++) {
          int from = column;
          int to = row;
          double difference = difference(step -> moved(before, from, step, dtS, after)[to], 4e-3);
          assertEquals(difference, transition[4 * row + column], 1e-9 * (1 + Math.abs(difference)));
        }
      }
    }
  }

  /** The error after a step of a state that was off in one entry before it. */
  private static double[] moved(
      AxisState before, int entry, double by, double dtS, AxisState after) {
    double[] error = new double[4];
    error[entry] = by;
    SpherePath path = SpherePath.of(before);
    path.displace(error);
    path.step(dtS, OrientationSettings.defaults().turning().decayS());
    return path.errorFrom(after);
  }

  @Test
  void axisStaysUnitAndItsFrameOrthonormal() {
    SplittableRandom random = new SplittableRandom(5);
    for (OrientationSettings settings :
        new OrientationSettings[] {
          OrientationSettings.defaults(),
          OrientationSettings.original(),
          OrientationSettings.defaults().with("form=quaternion")
        }) {
      AxisFilter filter =
          launched(
              settings,
              new double[] {0, 0.6, 0.8},
              new double[] {0.01, 0, 0, 0, 0.0064, -0.0048, 0, -0.0048, 0.0036});
      LineMeasurement[] lines = {null, null, null};
      for (int step = 0; step < 20_000; step++) {
        filter.predict(random.nextDouble(0.0001, 0.02));
        for (int i = 0; i < 3; i++) {
          lines[i] = line(random);
        }
        filter.update(lines, 3);
        assertEquals(1, Vectors.length(filter.axis().u()), 1e-12);
        assertTrue(filter.isValid(), "step " + step);
      }
    }
  }

  @Test
  void rollStaysUncertain() {
    SplittableRandom random = new SplittableRandom(6);
    for (String form : new String[] {"error-state", "quaternion"}) {
      OrientationSettings settings = OrientationSettings.defaults().with("form=" + form);
      double[] covariance = {0.001, 0, 0, 0, 0.001, 0, 0, 0, 0};
      AxisFilter filter = launched(settings, new double[] {0, 0, 1}, covariance);
      LineMeasurement[] lines = {line(random), line(random), line(random)};
      for (int step = 0; step < 200; step++) {
        filter.predict(0.01);
        for (LineMeasurement each : lines) {
          each.setAngle(angle(each, new double[] {0, 0, 1}));
        }
        filter.update(lines, 3);
      }
      assertTrue(Math.sqrt(filter.axis().variance()) < Math.toRadians(4), "the axis is known");
      assertTrue(
          filter.axis().rollSd() > Math.toRadians(95), form + " roll " + filter.axis().rollSd());
    }
  }

  @Test
  void bothFormsAgreeOnASlowRotation() {
    SplittableRandom random = new SplittableRandom(7);
    OrientationSettings settings =
        OrientationSettings.defaults()
            .with("turning.saccadeRateRadS=2", "turning.calmRateRadS=2", "gate.outlierShare=0");
    SphereFilter sphere = new SphereFilter(AxisModels.of(settings));
    QuaternionFilter quaternion =
        new QuaternionFilter(AxisModels.of(settings.with("form=quaternion")));
    double[] covariance = {0.001, 0, 0, 0, 0.001, 0, 0, 0, 0};
    sphere.launch(new double[] {0, 0, 1}, covariance);
    quaternion.launch(new double[] {0, 0, 1}, covariance);
    LineMeasurement[] lines = {line(random), line(random), line(random), line(random)};
    double[] truth = new double[3];
    for (int step = 0; step < 300; step++) {
      sphere.predict(0.01);
      quaternion.predict(0.01);
      double angle = 0.01 * step;
      truth[0] = Math.sin(angle);
      truth[2] = Math.cos(angle);
      for (LineMeasurement each : lines) {
        each.setAngle(angle(each, truth) + Math.toRadians(random.nextDouble(-2, 2)));
      }
      sphere.update(lines, 4);
      quaternion.update(lines, 4);
      double[] a = sphere.axis().u();
      double[] b = quaternion.axis().u();
      assertEquals(0, Math.toDegrees(Vectors.angle(a, b)), 0.6, "step " + step);
      assertEquals(0, Math.toDegrees(Vectors.angle(a, truth)), 6);
    }
    assertEquals(1, Math.sqrt(sphere.axis().variance() / quaternion.axis().variance()), 0.1);
  }
}
