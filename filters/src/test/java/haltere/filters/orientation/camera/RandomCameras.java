package haltere.filters.orientation.camera;

import java.util.SplittableRandom;

/** Cameras and directions at random. */
public final class RandomCameras {
  private RandomCameras() {}

  /** Focal length 800, principal point (310, 250), 1 m before the origin, turned at random. */
  public static CameraModel random(SplittableRandom random, double... distortion) {
    double[] forward = unit(random);
    double[] right = Vectors.orthogonalTo(forward);
    double[] top = new double[3];
    Vectors.cross(forward, right, top);
    double[] matrix = new double[12];
    for (int k = 0; k < 3; k++) {
      matrix[k] = 800 * right[k] + 310 * forward[k];
      matrix[4 + k] = 810 * top[k] + 250 * forward[k];
      matrix[8 + k] = forward[k];
    }
    matrix[3] = 310;
    matrix[7] = 250;
    matrix[11] = 1;
    double scale = random.nextDouble(-3, 3);
    for (int i = 0; i < 12; i++) {
      matrix[i] *= scale;
    }
    return CameraModel.of("a", matrix, distortion, 640, 480);
  }

  /** A direction, each as likely as any other. */
  public static double[] unit(SplittableRandom random) {
    double z = random.nextDouble(-1, 1);
    double angle = random.nextDouble(2 * Math.PI);
    double r = Math.sqrt(1 - z * z);
    return new double[] {r * Math.cos(angle), r * Math.sin(angle), z};
  }
}
