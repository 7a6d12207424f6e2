package haltere.filters.orientation;

import haltere.filters.estimation.FilterStep;
import haltere.filters.estimation.KalmanFilter;
import haltere.filters.estimation.UpdateOutcome;
import haltere.filters.estimation.motion.AxisMotion;
import haltere.filters.orientation.camera.CameraModel;
import haltere.filters.orientation.camera.LineObservation;
import java.util.List;
import java.util.function.Consumer;
import org.ejml.data.DMatrixRMaj;

/**
 * Kalman filter of position and velocity with white acceleration; measurements are pixels of each
 * camera; initialised by triangulation. State order x, ẋ, y, ẏ, z, ż.
 */
final class PositionFilter {
  /** Consecutive times without an accepted camera until re-initialisation. */
  private static final int LOST_AFTER = 5;

  private static final double START_SPEED_M_S = 1;

  private final List<CameraModel> cameras;
  private final Triangulation start;
  private final PixelMeasurement pixel;
  private final AxisMotion motion;
  private final DMatrixRMaj z = new DMatrixRMaj(2, 1);
  private KalmanFilter filter;
  private Consumer<? super FilterStep> recorder;
  private int rejectedTimes;

  PositionFilter(List<CameraModel> cameras, OrientationSettings.BodyMotion settings) {
    this.cameras = cameras;
    start = new Triangulation(settings.pixelSd());
    pixel = new PixelMeasurement(settings.pixelSd(), settings.gateSigmas());
    motion = AxisMotion.constantVelocity(3, settings.accelerationDensity());
  }

  boolean isRunning() {
    return filter != null;
  }

  void stop() {
    filter = null;
  }

  void record(Consumer<? super FilterStep> newRecorder) {
    recorder = newRecorder;
  }

  /** Initialises from nearly simultaneous pixels; false if they determine no position. */
  boolean launch(List<LineObservation> seen) {
    if (!start.find(cameras, seen)) {
      return false;
    }
    DMatrixRMaj x = new DMatrixRMaj(6, 1);
    DMatrixRMaj p = new DMatrixRMaj(6, 6);
    for (int i = 0; i < 3; i++) {
      x.set(2 * i, start.pointM[i]);
      for (int j = 0; j < 3; j++) {
        p.set(2 * i, 2 * j, start.covarianceM2.get(i, j));
      }
      p.set(2 * i + 1, 2 * i + 1, START_SPEED_M_S * START_SPEED_M_S);
    }
    filter = new KalmanFilter(motion, x, p);
    if (recorder != null) {
      filter.observe(recorder);
    }
    rejectedTimes = 0;
    return true;
  }

  void predict(double dtS) {
    filter.predict(dtS);
  }

  void update(List<LineObservation> seen) {
    int accepted = 0;
    int pixels = 0;
    for (LineObservation observation : seen) {
      CameraModel camera = cameras.get(observation.camera());
      double[] line = observation.line();
      if (!observation.hasPosition()
          || !camera.undistort(line)
          || !pixel.turnTo(camera, filter.state(0), filter.state(2), filter.state(4))) {
        continue;
      }
      pixels++;
      z.set(0, line[0]);
      z.set(1, line[1]);
      accepted += filter.update(pixel, z) == UpdateOutcome.APPLIED ? 1 : 0;
    }
    if (pixels > 0) {
      rejectedTimes = accepted > 0 ? 0 : rejectedTimes + 1;
    }
  }

  boolean isLost() {
    return rejectedTimes >= LOST_AFTER;
  }

  void position(double[] out) {
    for (int k = 0; k < 3; k++) {
      out[k] = filter.state(2 * k);
    }
  }

  void velocity(double[] out) {
    for (int k = 0; k < 3; k++) {
      out[k] = filter.state(2 * k + 1);
    }
  }

  /** Variance of the position along a unit vector, square metres. */
  double variance(double[] along) {
    double sum = 0;
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        sum += along[i] * filter.covariance(2 * i, 2 * j) * along[j];
      }
    }
    return sum;
  }
}
