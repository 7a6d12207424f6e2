package haltere.filters.orientation;

import haltere.filters.estimation.Gate;
import haltere.filters.estimation.MeasurementModel;
import haltere.filters.orientation.camera.CameraModel;
import org.ejml.data.DMatrixRMaj;

/** Undistorted pixel of a body in a camera; the state is position and velocity. */
final class PixelMeasurement implements MeasurementModel {
  private final Gate gate;
  private final double variance;
  private final double[] point = new double[3];
  private final double[] pixel = new double[2];
  private final double[] jacobian = new double[6];
  private CameraModel camera;

  /** A measurement that requires {@link #turnTo}. */
  PixelMeasurement(double pixelSd, double gateSigmas) {
    variance = pixelSd * pixelSd;
    gate = Gate.sigmas(gateSigmas);
  }

  /** Sets the camera and the position; false if the position is not visible. */
  boolean turnTo(CameraModel newCamera, double x, double y, double z) {
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
    boolean isSeen = turnTo(camera, x.get(0), x.get(2), x.get(4));
    z.set(0, isSeen ? pixel[0] : Double.NaN);
    z.set(1, isSeen ? pixel[1] : Double.NaN);
  }

  @Override
  public void jacobian(DMatrixRMaj x, DMatrixRMaj h) {
    turnTo(camera, x.get(0), x.get(2), x.get(4));
    camera.projectionJacobian(point, pixel, jacobian);
    h.zero();
    for (int k = 0; k < 6; k++) {
      h.set(k / 3, 2 * (k % 3), jacobian[k]);
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
}
