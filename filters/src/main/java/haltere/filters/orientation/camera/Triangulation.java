package haltere.filters.orientation.camera;

import java.util.List;
import java.util.Optional;

/**
 * A point in space from where cameras see it: the point nearest to all lines of sight, refined by
 * least squares in the pictures (Gauss and Newton; Hartley and Zisserman 2004, section 12.5), with
 * the covariance that follows. From three cameras on, one that contradicts the others is left out.
 *
 * @param xM place, metres
 * @param yM place, metres
 * @param zM place, metres
 * @param covarianceM2 of it, nine entries, square metres
 * @param cameras how many cameras agree
 */
public record Triangulation(
    double xM, double yM, double zM, List<Double> covarianceM2, int cameras) {
  private static final double WORST_PX = 5;
  private static final int ROUNDS = 5;

  /** Copies. */
  public Triangulation {
    covarianceM2 = List.copyOf(covarianceM2);
  }

  /**
   * Finds a point.
   *
   * @param cameras the cameras that {@link LineObservation#camera} counts
   * @param seen where it was seen; those without a place are left out
   * @param pixelSd standard deviation of a place in each coordinate, pixels
   * @return empty where fewer than two cameras tell or all look along the same line
   */
  public static Optional<Triangulation> of(
      List<CameraModel> cameras, List<LineObservation> seen, double pixelSd) {
    double[][] pixels = new double[seen.size()][];
    CameraModel[] models = new CameraModel[seen.size()];
    int count = 0;
    for (LineObservation observation : seen) {
      CameraModel camera = cameras.get(observation.camera());
      double[] line = {observation.xPx(), observation.yPx(), Double.NaN};
      if (observation.hasPlace() && camera.straighten(line)) {
        pixels[count] = line;
        models[count++] = camera;
      }
    }
    double[] point = new double[3];
    double[] covariance = new double[9];
    while (count >= 2) {
      if (!solve(models, pixels, count, pixelSd, point, covariance)) {
        return Optional.empty();
      }
      int worst = worst(models, pixels, count, point, Math.max(WORST_PX, 5 * pixelSd));
      if (worst < 0) {
        return Optional.of(
            new Triangulation(point[0], point[1], point[2], boxed(covariance), count));
      }
      if (count == 2) {
        return Optional.empty();
      }
      count--;
      models[worst] = models[count];
      pixels[worst] = pixels[count];
    }
    return Optional.empty();
  }

  private static List<Double> boxed(double[] values) {
    return java.util.Arrays.stream(values).boxed().toList();
  }

  /** The camera that is furthest off, or −1 if none is too far. */
  private static int worst(
      CameraModel[] models, double[][] pixels, int count, double[] point, double limitPx) {
    int worst = -1;
    double most = limitPx;
    double[] pixel = new double[2];
    for (int i = 0; i < count; i++) {
      boolean visible = models[i].projectIdeal(point, pixel);
      double off =
          visible
              ? Math.hypot(pixel[0] - pixels[i][0], pixel[1] - pixels[i][1])
              : Double.POSITIVE_INFINITY;
      if (off > most) {
        most = off;
        worst = i;
      }
    }
    return worst;
  }

  private static boolean solve(
      CameraModel[] models,
      double[][] pixels,
      int count,
      double pixelSd,
      double[] point,
      double[] covariance) {
    if (!nearest(models, pixels, count, point)) {
      return false;
    }
    double[] information = new double[9];
    double[] step = new double[3];
    double[] moved = new double[3];
    for (int round = 0; round < ROUNDS; round++) {
      java.util.Arrays.fill(information, 0);
      java.util.Arrays.fill(step, 0);
      for (int i = 0; i < count; i++) {
        if (!PixelMeasurement.addTo(models[i], pixels[i], point, information, step)) {
          return false;
        }
      }
      if (!Vectors.invertSymmetric(information, covariance)) {
        return false;
      }
      Vectors.multiply(covariance, step, moved);
      for (int k = 0; k < 3; k++) {
        point[k] += moved[k];
      }
    }
    double nearest = Double.POSITIVE_INFINITY;
    for (int i = 0; i < count; i++) {
      double[] centre = models[i].centre();
      nearest =
          Math.min(
              nearest,
              Math.hypot(
                  Math.hypot(point[0] - centre[0], point[1] - centre[1]), point[2] - centre[2]));
    }
    for (int k = 0; k < 9; k++) {
      covariance[k] *= pixelSd * pixelSd;
    }
    // A point that may as well be twice as far away is no point.
    double spread = covariance[0] + covariance[4] + covariance[8];
    return spread < 0.04 * nearest * nearest && Double.isFinite(point[0] + point[1] + point[2]);
  }

  /** Σ (I − d dᵀ)(x − c) = 0 over the lines of sight. */
  private static boolean nearest(
      CameraModel[] models, double[][] pixels, int count, double[] point) {
    double[] sum = new double[9];
    double[] right = new double[3];
    double[] d = new double[3];
    for (int i = 0; i < count; i++) {
      if (!models[i].sight(pixels[i][0], pixels[i][1], d)) {
        return false;
      }
      double[] c = models[i].centre();
      double along = Vectors.dot(c, d);
      for (int k = 0; k < 3; k++) {
        for (int l = 0; l < 3; l++) {
          sum[3 * k + l] += (k == l ? 1 : 0) - d[k] * d[l];
        }
        right[k] += c[k] - along * d[k];
      }
    }
    double[] inverse = new double[9];
    if (!Vectors.invertSymmetric(sum, inverse)) {
      return false;
    }
    Vectors.multiply(inverse, right, point);
    return true;
  }
}
