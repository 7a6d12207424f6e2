package haltere.filters.orientation;

import haltere.filters.estimation.FilterOptions;
import haltere.filters.estimation.FilterStep;
import haltere.filters.estimation.GapPolicy;
import haltere.filters.estimation.KalmanFilter;
import haltere.filters.estimation.UpdateOutcome;
import haltere.filters.estimation.motion.ConstantVelocity;
import haltere.filters.orientation.camera.CameraModel;
import haltere.filters.orientation.camera.LineObservation;
import haltere.filters.orientation.camera.PixelMeasurement;
import haltere.filters.orientation.camera.Triangulation;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.ejml.data.DMatrixRMaj;

/**
 * Where a body is: place and velocity, driven by white acceleration, corrected by each camera's
 * pixels; started by triangulation. State order x, ẋ, y, ẏ, z, ż.
 */
final class PositionFilter {
  /** Instants in a row at which no camera was believed, after which the body is searched anew. */
  private static final int LOST_AFTER = 5;

  private static final double START_SPEED_M_S = 1;

  private final List<CameraModel> cameras;
  private final BodyPositionSettings settings;
  private final PixelMeasurement pixel;
  private final ConstantVelocity motion;
  private final DMatrixRMaj z = new DMatrixRMaj(2, 1);
  private final double[] line = new double[3];
  private KalmanFilter filter;
  private Consumer<? super FilterStep> recorder;
  private int disbelieved;

  PositionFilter(List<CameraModel> cameras, BodyPositionSettings settings) {
    this.cameras = cameras;
    this.settings = settings;
    pixel = new PixelMeasurement(settings.pixelSd(), settings.gateSigmas());
    motion = new ConstantVelocity(3, settings.accelerationDensity());
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

  /** Starts from places that were seen nearly together; false if they do not tell. */
  boolean launch(List<LineObservation> seen) {
    Optional<Triangulation> found = Triangulation.of(cameras, seen, settings.pixelSd());
    if (found.isEmpty()) {
      return false;
    }
    Triangulation point = found.get();
    DMatrixRMaj x = new DMatrixRMaj(6, 1);
    x.set(0, point.xM());
    x.set(2, point.yM());
    x.set(4, point.zM());
    DMatrixRMaj p = new DMatrixRMaj(6, 6);
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        p.set(2 * i, 2 * j, point.covarianceM2().get(3 * i + j));
      }
      p.set(2 * i + 1, 2 * i + 1, START_SPEED_M_S * START_SPEED_M_S);
    }
    filter = new KalmanFilter(motion, x, p, FilterOptions.DEFAULT.withGap(GapPolicy.UNLIMITED));
    if (recorder != null) {
      filter.observe(recorder);
    }
    disbelieved = 0;
    return true;
  }

  void predict(double dtS) {
    filter.predict(dtS);
  }

  /** Takes in where cameras see the body; returns how many were believed. */
  int update(List<LineObservation> seen) {
    int believed = 0;
    int places = 0;
    for (LineObservation observation : seen) {
      CameraModel camera = cameras.get(observation.camera());
      line[0] = observation.xPx();
      line[1] = observation.yPx();
      line[2] = Double.NaN;
      if (!observation.hasPlace()
          || !camera.straighten(line)
          || !pixel.turnTo(camera, filter.state(0), filter.state(2), filter.state(4))) {
        continue;
      }
      places++;
      z.set(0, line[0]);
      z.set(1, line[1]);
      if (filter.update(pixel, z) == UpdateOutcome.APPLIED) {
        believed++;
      }
    }
    if (places > 0) {
      disbelieved = believed > 0 ? 0 : disbelieved + 1;
    }
    return believed;
  }

  boolean isLost() {
    return disbelieved >= LOST_AFTER;
  }

  void place(double[] out) {
    for (int k = 0; k < 3; k++) {
      out[k] = filter.state(2 * k);
    }
  }

  void velocity(double[] out) {
    for (int k = 0; k < 3; k++) {
      out[k] = filter.state(2 * k + 1);
    }
  }

  /** Variance of the place along a unit vector, square metres. */
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
