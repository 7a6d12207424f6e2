package haltere.filters.orientation.camera;

import haltere.filters.estimation.Gate;
import haltere.filters.estimation.MeasurementModel;
import org.ejml.data.DMatrixRMaj;

/** Where a camera sees a body of which place and velocity are the state; the lens left out. */
public final class PixelMeasurement implements MeasurementModel {
  private final Gate gate;
  private final double variance;
  private final double[] point = new double[3];
  private final double[] pixel = new double[2];
  private final double[] jacobian = new double[6];
  private CameraModel camera;

  /**
   * A measurement without a camera, to be {@link #turnTo turned to} one.
   *
   * @param pixelSd standard deviation of a place in each coordinate, pixels
   * @param gateSigmas how far off a place may be, standard deviations
   */
  public PixelMeasurement(double pixelSd, double gateSigmas) {
    variance = pixelSd * pixelSd;
    gate = Gate.sigmas(gateSigmas);
  }

  /**
   * Turns to a camera.
   *
   * @param newCamera the camera
   * @param x place of the body, metres
   * @param y place of the body, metres
   * @param z place of the body, metres
   * @return false if it does not see such a place
   */
  public boolean turnTo(CameraModel newCamera, double x, double y, double z) {
    camera = newCamera;
    point[0] = x;
    point[1] = y;
    point[2] = z;
    return camera.projectIdeal(point, pixel);
  }

  @Override
  public int size() {
    return 2;
  }

  @Override
  public void expected(DMatrixRMaj x, DMatrixRMaj z) {
    if (!turnTo(camera, x.get(0), x.get(2), x.get(4))) {
      pixel[0] = Double.NaN;
      pixel[1] = Double.NaN;
    }
    z.set(0, pixel[0]);
    z.set(1, pixel[1]);
  }

  @Override
  public void jacobian(DMatrixRMaj x, DMatrixRMaj h) {
    turnTo(camera, x.get(0), x.get(2), x.get(4));
    camera.pixelByPoint(point, pixel, jacobian);
    h.zero();
    for (int k = 0; k < 3; k++) {
      h.set(0, 2 * k, jacobian[k]);
      h.set(1, 2 * k, jacobian[3 + k]);
    }
  }

  @Override
  public void noise(DMatrixRMaj x, DMatrixRMaj r) {
    r.zero();
    r.set(0, 0, variance);
    r.set(1, 1, variance);
  }

  @Override
  public Gate gate() {
    return gate;
  }

  /** Adds Jᵀ J and Jᵀ times the miss of a camera; false if it does not see the point. */
  static boolean addTo(
      CameraModel camera, double[] seen, double[] point, double[] information, double[] step) {
    double[] pixel = new double[2];
    double[] j = new double[6];
    if (!camera.projectIdeal(point, pixel)) {
      return false;
    }
    camera.pixelByPoint(point, pixel, j);
    for (int k = 0; k < 3; k++) {
      for (int l = 0; l < 3; l++) {
        information[3 * k + l] += j[k] * j[l] + j[3 + k] * j[3 + l];
      }
      step[k] += j[k] * (seen[0] - pixel[0]) + j[3 + k] * (seen[1] - pixel[1]);
    }
    return true;
  }
}
