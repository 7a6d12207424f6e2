package haltere.filters.orientation.camera;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.Angles;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class CameraModelTest {
  private static final double[] DISTORTION = {-0.3, 0.12, 0.002, -0.001, -0.02};

  private static double[] near(SplittableRandom random) {
    return new double[] {
      random.nextDouble(-0.2, 0.2), random.nextDouble(-0.2, 0.2), random.nextDouble(-0.2, 0.2)
    };
  }

  private static double angleOfProjection(CameraModel camera, double[] at, double[] axis) {
    double[] ahead = new double[2];
    double[] behind = new double[2];
    double step = 1e-5;
    double[] a = {at[0] + step * axis[0], at[1] + step * axis[1], at[2] + step * axis[2]};
    double[] b = {at[0] - step * axis[0], at[1] - step * axis[1], at[2] - step * axis[2]};
    assertTrue(camera.project(a, ahead) && camera.project(b, behind));
    return Math.atan2(ahead[1] - behind[1], ahead[0] - behind[0]);
  }

  @Test
  void angleOfALineMatchesItsProjection() {
    SplittableRandom random = new SplittableRandom(1);
    for (int i = 0; i < 200; i++) {
      CameraModel camera =
          i % 2 == 0 ? RandomCameras.random(random) : RandomCameras.random(random, DISTORTION);
      double[] at = near(random);
      double[] axis = RandomCameras.unit(random);
      double angle = camera.heading(at, axis);
      assertEquals(
          0, Angles.wrapHalfPi(angle - angleOfProjection(camera, at, axis)), 1e-6, "case " + i);
      double[] back = {-3 * axis[0], -3 * axis[1], -3 * axis[2]};
      assertEquals(-1, Math.cos(angle - camera.heading(at, back)), 1e-15, "the other way");
    }
  }

  @Test
  void distortionIsInvertedForPointsAndLines() {
    SplittableRandom random = new SplittableRandom(2);
    for (int i = 0; i < 200; i++) {
      CameraModel camera = RandomCameras.random(random, DISTORTION);
      double[] at = near(random);
      double[] axis = RandomCameras.unit(random);
      double[] ideal = new double[2];
      double[] seen = new double[2];
      camera.projectIdeal(at, ideal);
      camera.project(at, seen);
      double[] n = new double[6];
      camera.lineNormals(at, n);
      double[] line = {seen[0], seen[1], camera.heading(at, axis)};
      assertTrue(camera.undistort(line));
      assertEquals(ideal[0], line[0], 1e-8);
      assertEquals(ideal[1], line[1], 1e-8);
      double vx = n[0] * axis[0] + n[1] * axis[1] + n[2] * axis[2];
      double vy = n[3] * axis[0] + n[4] * axis[1] + n[5] * axis[2];
      assertEquals(0, Angles.wrapHalfPi(line[2] - Math.atan2(vy, vx)), 1e-6);
    }
  }

  @Test
  void foldedRegionOfAStrongLensHasNoPoint() {
    CameraModel camera = RandomCameras.random(new SplittableRandom(3), -0.5, 0, 0, 0, 0);
    double[] line = {310 + 3000, 250, 0.3};
    assertFalse(camera.undistort(line));
    assertEquals(3310, line[0]);
  }

  @Test
  void cameraCentreHasNeitherPixelNorLine() {
    CameraModel camera = RandomCameras.random(new SplittableRandom(4));
    double[] n = new double[6];
    assertFalse(camera.project(camera.centre(), new double[2]));
    assertFalse(camera.lineNormals(camera.centre(), n));
    assertTrue(Double.isNaN(camera.heading(camera.centre(), new double[] {1, 0, 0})));
  }

  @Test
  void degenerateMatricesAreReportedAndNotUsed() {
    double[] rankTwo = {800, 0, 300, 300, 0, 800, 250, 250, 800, 800, 550, 550};
    CameraModel camera = CameraModel.of("flat", rankTwo, new double[0], 0, 0);
    assertTrue(camera.problem().orElseThrow().contains("rank"), camera.problem().toString());
    assertFalse(camera.project(new double[] {0, 0, 5}, new double[2]));
    assertFalse(camera.undistort(new double[] {1, 1, 1}));
    double[] holes = new double[12];
    holes[3] = Double.NaN;
    assertTrue(CameraModel.of("none", holes, new double[0], 0, 0).problem().isPresent());
    assertTrue(CameraModel.of("zero", new double[12], new double[0], 0, 0).problem().isPresent());
  }
}
