package haltere.filters.orientation;

import haltere.filters.orientation.camera.CameraModel;
import haltere.filters.orientation.camera.LineObservation;
import haltere.filters.orientation.camera.Vectors;
import java.util.ArrayList;
import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * Triangulation of a point: the point nearest to all lines of sight, refined by least squares in
 * the pictures (Gauss-Newton; Hartley and Zisserman 2004, section 12.5), with its covariance. With
 * three or more cameras, one that contradicts the others is excluded.
 */
final class Triangulation {
  private static final double MIN_LIMIT_PX = 5;
  private static final int ROUNDS = 5;

  /** Largest standard deviation of a point over its distance. */
  private static final double MAX_RELATIVE_SD = 0.2;

  /** A line of sight: a camera and its undistorted pixel. */
  private record Sight(CameraModel camera, double[] pixel) {
    /** Distance to the projection of a point; infinite if it is not visible. */
    double missPx(double[] point) {
      double[] seen = new double[2];
      return camera.projectIdeal(point, seen)
          ? Math.hypot(seen[0] - pixel[0], seen[1] - pixel[1])
          : Double.POSITIVE_INFINITY;
    }
  }

  final double[] pointM = new double[3];

  final DMatrixRMaj covarianceM2 = new DMatrixRMaj(3, 3);

  private final List<Sight> sights = new ArrayList<>();
  private final double pixelSd;

  /** A triangulation of positions with a standard deviation in each coordinate, pixels. */
  Triangulation(double pixelSd) {
    this.pixelSd = pixelSd;
  }

  /** Triangulates; false with fewer than two usable cameras or collinear lines of sight. */
  boolean find(List<CameraModel> cameras, List<LineObservation> seen) {
    sights.clear();
    for (LineObservation observation : seen) {
      CameraModel camera = cameras.get(observation.camera());
      double[] line = observation.line();
      if (observation.hasPosition() && camera.undistort(line)) {
        sights.add(new Sight(camera, line));
      }
    }
    while (sights.size() >= 2 && nearest() && refine()) {
      Sight worst = sights.get(0);
      for (Sight each : sights) {
        worst = each.missPx(pointM) > worst.missPx(pointM) ? each : worst;
      }
      if (worst.missPx(pointM) <= Math.max(MIN_LIMIT_PX, 5 * pixelSd)) {
        return true;
      }
      if (sights.size() == 2) {
        return false;
      }
      sights.remove(worst);
    }
    return false;
  }

  private boolean refine() {
    DMatrixRMaj information = new DMatrixRMaj(3, 3);
    DMatrixRMaj right = new DMatrixRMaj(3, 1);
    DMatrixRMaj jacobian = new DMatrixRMaj(2, 3);
    double[] pixel = new double[2];
    double[] step = new double[3];
    for (int round = 0; round < ROUNDS; round++) {
      information.zero();
      right.zero();
      for (Sight each : sights) {
        if (!each.camera().projectIdeal(pointM, pixel)) {
          return false;
        }
        each.camera().projectionJacobian(pointM, pixel, jacobian.data);
        CommonOps_DDRM.multAddTransA(jacobian, jacobian, information);
        double[] seen = each.pixel();
        CommonOps_DDRM.multAddTransA(
            jacobian, new DMatrixRMaj(2, 1, true, seen[0] - pixel[0], seen[1] - pixel[1]), right);
      }
      if (!CommonOps_DDRM.invertSPD(information, covarianceM2)) {
        return false;
      }
      Vectors.multiply(covarianceM2.data, right.data, step);
      for (int k = 0; k < 3; k++) {
        pointM[k] += step[k];
      }
    }
    double nearest = Double.POSITIVE_INFINITY;
    for (Sight each : sights) {
      double[] centre = each.camera().centre();
      double[] away = {pointM[0] - centre[0], pointM[1] - centre[1], pointM[2] - centre[2]};
      nearest = Math.min(nearest, Vectors.length(away));
    }
    CommonOps_DDRM.scale(pixelSd * pixelSd, covarianceM2);
    double sd = Math.sqrt(CommonOps_DDRM.trace(covarianceM2));
    return sd < MAX_RELATIVE_SD * nearest && Double.isFinite(Vectors.length(pointM));
  }

  /** Σ (I − d dᵀ)(x − c) = 0 over the lines of sight. */
  private boolean nearest() {
    DMatrixRMaj sum = new DMatrixRMaj(3, 3);
    double[] right = new double[3];
    double[] d = new double[3];
    for (Sight each : sights) {
      if (!each.camera().lineOfSight(each.pixel()[0], each.pixel()[1], d)) {
        return false;
      }
      double[] c = each.camera().centre();
      double along = Vectors.dot(c, d);
      for (int k = 0; k < 9; k++) {
        sum.data[k] += (k % 4 == 0 ? 1 : 0) - d[k / 3] * d[k % 3];
      }
      for (int k = 0; k < 3; k++) {
        right[k] += c[k] - along * d[k];
      }
    }
    DMatrixRMaj inverse = new DMatrixRMaj(3, 3);
    boolean isPoint = CommonOps_DDRM.invertSPD(sum, inverse);
    Vectors.multiply(inverse.data, right, pointM);
    return isPoint;
  }
}
