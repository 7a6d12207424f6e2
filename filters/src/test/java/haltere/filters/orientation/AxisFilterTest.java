package haltere.filters.orientation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.Angles;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class AxisFilterTest {
  private static final double STEP = 1e-6;

  private static LineMeasurement line(SplittableRandom random) {
    LineMeasurement line = new LineMeasurement();
    double[] at = {random.nextDouble(-0.1, 0.1), random.nextDouble(-0.1, 0.1), 0.05};
    assertTrue(CameraModelTest.random(random).lineNormals(at, line.n));
    line.angleRad = random.nextDouble(-1.5, 1.5);
    line.varianceRad2 = Math.toRadians(2) * Math.toRadians(2);
    return line;
  }

  private static double angle(LineMeasurement line, double[] u) {
    double vx = line.n[0] * u[0] + line.n[1] * u[1] + line.n[2] * u[2];
    double vy = line.n[3] * u[0] + line.n[4] * u[1] + line.n[5] * u[2];
    return Math.atan2(vy, vx);
  }

  @Test
  void theGradientOfAnAngleIsThatOfDifferences() {
    SplittableRandom random = new SplittableRandom(1);
    double[] gradient = new double[3];
    int compared = 0;
    for (int i = 0; i < 500; i++) {
      LineMeasurement line = line(random);
      double[] u = CameraModelTest.unit(random);
      line.gradient(u, gradient);
      if (Vectors.length(gradient) > 3) {
        continue; // seen end-on, where differences are no measure
      }
      for (int k = 0; k < 3; k++) {
        double[] more = u.clone();
        double[] less = u.clone();
        more[k] += 1e-5;
        less[k] -= 1e-5;
        double difference = Angles.wrapPi(angle(line, more) - angle(line, less)) / 2e-5;
        assertEquals(difference, gradient[k], 1e-8 * (1 + Math.abs(difference)) + 1e-9);
      }
      assertEquals(0, Vectors.dot(gradient, u), 1e-12, "a longer axis looks the same");
      compared++;
    }
    assertTrue(compared > 200, compared + " compared");
  }

  @Test
  void theGradientByTheQuaternionIsThatOfDifferencesToTheNinthDigit() {
    SplittableRandom random = new SplittableRandom(2);
    double[] gradient = new double[3];
    double[] u = new double[3];
    for (int i = 0; i < 300; i++) {
      double[] x = state(random);
      LineMeasurement line = line(random);
      QuaternionFilter.axis(x, u);
      line.gradient(u, gradient);
      if (Vectors.length(gradient) > 3) {
        continue;
      }
      for (int j = 0; j < 4; j++) {
        double analytic = 0;
        for (int row = 0; row < 3; row++) {
          analytic += gradient[row] * QuaternionFilter.axisByQuaternion(x, row, j);
        }
        // Fourth order differences: their own error is below 1e-11 here.
        double h = 2e-3;
        double difference =
            (8 * (at(line, x, j, h) - at(line, x, j, -h))
                    - (at(line, x, j, 2 * h) - at(line, x, j, -2 * h)))
                / (12 * h);
        double finer =
            (8 * (at(line, x, j, h / 2) - at(line, x, j, -h / 2))
                    - (at(line, x, j, h) - at(line, x, j, -h)))
                / (6 * h);
        assertEquals((16 * finer - difference) / 15, analytic, 1e-9 * (1 + Math.abs(analytic)));
      }
      double radial = 0;
      double[] roll = {x[6], x[5], -x[4], -x[3]};
      double aboutAxis = 0;
      for (int j = 0; j < 4; j++) {
        double sum = 0;
        for (int row = 0; row < 3; row++) {
          sum += gradient[row] * QuaternionFilter.axisByQuaternion(x, row, j);
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
    QuaternionFilter.axis(x, u);
    double before = angle(line, u);
    double[] moved = x.clone();
    moved[3 + j] += step;
    QuaternionFilter.axis(moved, u);
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
  void theDerivativeOfTheQuaternionKeepsItsLengthAsTheSourcesDoesNot() {
    SplittableRandom random = new SplittableRandom(3);
    double[] rate = new double[7];
    for (int i = 0; i < 100; i++) {
      double[] x = state(random);
      QuaternionFilter.derivative(x, 0.1, rate);
      double along = x[3] * rate[3] + x[4] * rate[4] + x[5] * rate[5] + x[6] * rate[6];
      assertEquals(0, along, 1e-13);
    }
  }

  @Test
  void neighbouringWaysOnTheSpherePartAsTheTransitionSays() {
    SplittableRandom random = new SplittableRandom(4);
    for (int i = 0; i < 50; i++) {
      double dtS = random.nextDouble(1e-4, 0.03);
      SpherePath start = SpherePath.random(random, 25);
      SphereFilter filter = new SphereFilter(OrientationSettings.defaults());
      start.putInto(filter);
      AxisState before = filter.state();
      filter.predict(dtS);
      double[] transition = filter.transition();
      AxisState after = filter.predictedState();
      for (int column = 0; column < 4; column++) {
        double[] more = moved(before, column, STEP, dtS, after);
        double[] less = moved(before, column, -STEP, dtS, after);
        for (int row = 0; row < 4; row++) {
          double difference = (more[row] - less[row]) / (2 * STEP);
          assertEquals(difference, transition[4 * row + column], 1e-7 * (1 + Math.abs(difference)));
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
    path.step(dtS, 0.1);
    return path.errorFrom(after);
  }

  @Test
  void theAxisStaysOfLengthOneAndItsFrameSquare() {
    SplittableRandom random = new SplittableRandom(5);
    for (OrientationSettings settings :
        new OrientationSettings[] {
          OrientationSettings.defaults(),
          OrientationSettings.original(),
          OrientationSettings.defaults().with("form=quaternion")
        }) {
      AxisFilter filter =
          settings.form() == OrientationSettings.Form.QUATERNION
              ? new QuaternionFilter(settings)
              : new SphereFilter(settings);
      filter.launch(
          new double[] {0, 0.6, 0.8},
          new double[] {0.01, 0, 0, 0, 0.0064, -0.0048, 0, -0.0048, 0.0036});
      double[] u = new double[3];
      LineMeasurement[] lines = {null, null, null};
      for (int step = 0; step < 20_000; step++) {
        filter.predict(random.nextDouble(0.0001, 0.02));
        for (int i = 0; i < 3; i++) {
          lines[i] = line(random);
        }
        filter.update(lines, 3);
        filter.axis(u);
        assertEquals(1, Vectors.length(u), 1e-12);
        assertTrue(filter.isSound(), "step " + step);
      }
    }
  }

  @Test
  void whatNobodySeesIsNeverSure() {
    SplittableRandom random = new SplittableRandom(6);
    for (String form : new String[] {"error-state", "quaternion"}) {
      OrientationSettings settings = OrientationSettings.defaults().with("form=" + form);
      AxisFilter filter =
          form.equals("quaternion") ? new QuaternionFilter(settings) : new SphereFilter(settings);
      filter.launch(new double[] {0, 0, 1}, new double[] {0.001, 0, 0, 0, 0.001, 0, 0, 0, 0});
      LineMeasurement[] lines = {line(random), line(random), line(random)};
      for (int step = 0; step < 200; step++) {
        filter.predict(0.01);
        for (LineMeasurement each : lines) {
          each.angleRad = angle(each, new double[] {0, 0, 1});
        }
        filter.update(lines, 3);
      }
      assertTrue(Math.sqrt(filter.axisVariance()) < Math.toRadians(4), "the axis is known");
      assertTrue(filter.rollSd() > Math.toRadians(95), form + " roll " + filter.rollSd());
    }
  }

  @Test
  void bothFormsAgreeOnABodyThatTurnsCalmly() {
    SplittableRandom random = new SplittableRandom(7);
    OrientationSettings settings =
        OrientationSettings.defaults()
            .with("turning.saccadeRateRadS=2", "turning.calmRateRadS=2", "gate.outlierShare=0");
    SphereFilter sphere = new SphereFilter(settings);
    QuaternionFilter quaternion = new QuaternionFilter(settings.with("form=quaternion"));
    double[] covariance = {0.001, 0, 0, 0, 0.001, 0, 0, 0, 0};
    sphere.launch(new double[] {0, 0, 1}, covariance);
    quaternion.launch(new double[] {0, 0, 1}, covariance);
    LineMeasurement[] lines = {line(random), line(random), line(random), line(random)};
    double[] a = new double[3];
    double[] b = new double[3];
    double[] truth = new double[3];
    for (int step = 0; step < 300; step++) {
      sphere.predict(0.01);
      quaternion.predict(0.01);
      double angle = 0.01 * step;
      truth[0] = Math.sin(angle);
      truth[2] = Math.cos(angle);
      for (LineMeasurement each : lines) {
        each.angleRad = angle(each, truth) + Math.toRadians(random.nextDouble(-2, 2));
      }
      sphere.update(lines, 4);
      quaternion.update(lines, 4);
      sphere.axis(a);
      quaternion.axis(b);
      assertEquals(0, Math.toDegrees(Vectors.angle(a, b)), 0.6, "step " + step);
      assertEquals(0, Math.toDegrees(Vectors.angle(a, truth)), 6);
    }
    assertEquals(1, Math.sqrt(sphere.axisVariance() / quaternion.axisVariance()), 0.1);
  }
}
