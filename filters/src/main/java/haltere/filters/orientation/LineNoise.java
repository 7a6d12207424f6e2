package haltere.filters.orientation;

import haltere.filters.orientation.internal.axis.LineMeasurement;
import java.util.Arrays;

/** Variance of the angles of each camera, estimated from its own detections. */
final class LineNoise {
  /** Detections over which the variance of a camera is averaged. */
  private static final double MEMORY = 300;

  /** Weight of the initial variance, in detections. */
  private static final double INITIAL_WEIGHT = 30;

  private static final double MIN_SD = Math.toRadians(0.05);
  private static final double MAX_SD = Math.toRadians(30);

  private final OrientationSettings.AngleNoise settings;
  final double[] variances;
  private final double[] weights;

  LineNoise(OrientationSettings.AngleNoise settings, int cameras) {
    this.settings = settings;
    variances = new double[cameras];
    double sd = Math.toRadians(settings.angleSdDeg());
    Arrays.fill(variances, sd * sd);
    weights = new double[cameras];
    Arrays.fill(weights, INITIAL_WEIGHT);
  }

  /** Updates with the estimate of the variance by one line. */
  void update(LineMeasurement each) {
    double now = each.ownRad2;
    if (settings.calibrate() && Double.isFinite(now)) {
      double variance = variances[each.camera];
      double weight = Math.min(MEMORY, weights[each.camera] + 1);
      weights[each.camera] = weight;
      variance += (now - variance) / weight;
      variances[each.camera] = Math.min(MAX_SD * MAX_SD, Math.max(MIN_SD * MIN_SD, variance));
    }
  }

  double sdRad(int camera) {
    return Math.sqrt(variances[camera]);
  }
}
