package haltere.filters.track;

import haltere.filters.estimation.GaussianState;
import haltere.filters.estimation.motion.AxisMotion;
import haltere.filters.plane.PlaneJacobian;
import haltere.filters.plane.PlaneMapping;
import haltere.filters.plane.PlanePoint;
import haltere.filters.trail.Ellipse;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * The Kalman filter of tracks: a track predicted to a time, on the plane and in the picture, and
 * its correction, in pixels, by the location z of its cluster. Reused.
 *
 * <pre>
 * predict   x⁻ = F x           P⁻ = F P Fᵀ + Q            F, Q: constant velocity
 * correct   x = x⁻ + K (z − h(x⁻))                        h: plane to pixels, H = ∂h/∂x at x⁻
 *           K = P⁻ Hᵀ (H P⁻ Hᵀ + r I)⁻¹                   on the plane the variance r is J r Jᵀ
 * </pre>
 */
final class TrackPrediction {
  /** Measurement variance of a new track where variances are dynamic, px²: Cardinale (2006). */
  private static final double START_MEASUREMENT_VARIANCE = 1;

  /** Process variance of a new track over its end where variances are dynamic: Cardinale (2006). */
  private static final double START_PROCESS_FACTOR = 10;

  private final PlaneMapping mapping;
  private final TrackFilterSettings settings;
  private final double endProcessVariance;
  private final AxisMotion motion;
  private final GaussianState state = new GaussianState(4);
  private final DMatrixRMaj q = new DMatrixRMaj(4, 4);
  private final double[] row = new double[4];
  private long timeUs;
  private PlaneJacobian toPlane;
  private PlaneJacobian toPixels;
  Track track;
  double xPx;
  double yPx;

  TrackPrediction(PlaneMapping mapping, KalmanTracksSettings all) {
    this.mapping = mapping;
    settings = all.filter();
    RoadTracksSettings road = all.road();
    endProcessVariance = road.mapToRoad() ? road.processVariance() : settings.minProcessVariance();
    AxisMotion velocity = AxisMotion.constantVelocity(2, 1);
    motion =
        settings.noise() == TrackFilterSettings.Noise.DENSITY
            ? velocity
            : velocity.withNoisePerStep(1);
  }

  private double measurementVariance(Track of) {
    double end = settings.maxMeasurementVariance();
    double start = Math.min(START_MEASUREMENT_VARIANCE, end);
    return settings.dynamicVariances() ? end + of.initialShare * (start - end) : end;
  }

  private double processVariance(Track of) {
    double factor =
        settings.dynamicVariances() ? 1 + of.initialShare * (START_PROCESS_FACTOR - 1) : 1;
    return factor * endProcessVariance;
  }

  /** Starts a track at a cluster that sees the plane, with an unknown velocity. */
  void start(Track born) {
    double startXPx = born.cluster.xPx();
    double startYPx = born.cluster.yPx();
    PlaneJacobian jacobian = mapping.jacobian(startXPx, startYPx);
    born.timeUs = born.seenUs;
    born.belief.setMean(0, mapping.planeX(startXPx, startYPx));
    born.belief.setMean(2, mapping.planeY(startXPx, startYPx));
    double r = measurementVariance(born);
    double v = settings.launchSpeedPxS() * settings.launchSpeedPxS();
    born.belief.setVariances(
        jacobian.xx(r, 0, r), jacobian.xx(v, 0, v), jacobian.yy(r, 0, r), jacobian.yy(v, 0, v));
    born.belief.addNoise(0, 2, jacobian.xy(r, 0, r));
    born.belief.addNoise(1, 3, jacobian.xy(v, 0, v));
    born.count();
  }

  /** Predicts a track; false if it is not visible there. The track is not changed. */
  boolean predict(Track predicted, long predictedUs) {
    track = predicted;
    timeUs = predictedUs;
    state.set(track.belief);
    double dtS = 1e-6 * (timeUs - track.timeUs);
    if (dtS > 0) {
      motion.noise(state.mean(), dtS, q);
      CommonOps_DDRM.scale(processVariance(track), q);
      state.shear(0, 1, dtS);
      state.shear(2, 3, dtS);
      CommonOps_DDRM.addEquals(state.covariance(), q);
    }
    if (!mapping.isSeen(state.mean(0), state.mean(2))) {
      return false;
    }
    xPx = mapping.pixelX(state.mean(0), state.mean(2));
    yPx = mapping.pixelY(state.mean(0), state.mean(2));
    PlaneJacobian jacobian = mapping.jacobian(xPx, yPx);
    if (!jacobian.equals(toPlane)) {
      toPlane = jacobian;
      toPixels = jacobian.inverse();
    }
    return true;
  }

  /** Corrects the predicted track by the location of its cluster; gives the result if wanted. */
  TrackUpdate correct(boolean wanted) {
    double r = measurementVariance(track);
    double dx = track.cluster.xPx() - xPx;
    double dy = track.cluster.yPx() - yPx;
    GaussianState belief = track.belief;
    belief.set(state);
    correct(belief, toPixels.xu(), toPixels.xv(), dx, r);
    double movedX = belief.mean(0) - state.mean(0);
    double movedY = belief.mean(2) - state.mean(2);
    correct(belief, toPixels.yu(), toPixels.yv(), dy - toPixels.y(movedX, movedY), r);
    track.timeUs = timeUs;
    track.count();
    return wanted ? result(belief, r, dx, dy) : null;
  }

  private void correct(GaussianState belief, double byX, double byY, double innovation, double r) {
    row[0] = byX;
    row[2] = byY;
    belief.project(row);
    belief.correct(innovation, r);
  }

  private TrackUpdate result(GaussianState belief, double r, double dx, double dy) {
    return new TrackUpdate(
        timeUs,
        track.id,
        state.mean(0) + toPlane.x(dx, dy),
        state.mean(2) + toPlane.y(dx, dy),
        r,
        q.get(0, 0),
        q.get(0, 1),
        q.get(1, 1),
        dx,
        dy,
        xxPx2(0) + r,
        covarianceXyPx2(),
        yyPx2(0) + r,
        distance2(xPx + dx, yPx + dy),
        // K = P Hᵀ R⁻¹ with the P after the update.
        toPixels.x(belief.covariance(0, 0), belief.covariance(0, 2)) / r,
        toPixels.y(belief.covariance(2, 0), belief.covariance(2, 2)) / r,
        toPixels.x(belief.covariance(1, 0), belief.covariance(1, 2)) / r,
        toPixels.y(belief.covariance(3, 0), belief.covariance(3, 2)) / r,
        belief.mean(0),
        belief.mean(2),
        belief.mean(1),
        belief.mean(3),
        belief.covariance(0, 0),
        belief.covariance(0, 1),
        belief.covariance(1, 1),
        belief.covariance(2, 2),
        belief.covariance(2, 3),
        belief.covariance(3, 3));
  }

  /** Squared Mahalanobis distance of a location from the predicted one. */
  double distance2(double measuredXPx, double measuredYPx) {
    double xx = measurementVariance(track) + xxPx2(0);
    double yy = measurementVariance(track) + yyPx2(0);
    double xy = covarianceXyPx2();
    double dx = measuredXPx - xPx;
    double dy = measuredYPx - yPx;
    return (yy * dx * dx - 2 * xy * dx * dy + xx * dy * dy) / (xx * yy - xy * xy);
  }

  /** Variance of the column, or with an offset of 1 of its velocity. */
  private double xxPx2(int offset) {
    return toPixels.xx(p(offset, offset), p(offset, 2 + offset), p(2 + offset, 2 + offset));
  }

  private double yyPx2(int offset) {
    return toPixels.yy(p(offset, offset), p(offset, 2 + offset), p(2 + offset, 2 + offset));
  }

  private double covarianceXyPx2() {
    return toPixels.xy(p(0, 0), p(0, 2), p(2, 2));
  }

  /** Standard deviations of the predicted position in the picture. */
  Ellipse ellipse() {
    return Ellipse.of(xxPx2(0), covarianceXyPx2(), yyPx2(0));
  }

  private double p(int i, int j) {
    return state.covariance(i, j);
  }

  /** The predicted track in the picture. */
  TrackPoint point() {
    return new TrackPoint(
        timeUs,
        track.id,
        xPx,
        yPx,
        toPixels.x(state.mean(1), state.mean(3)),
        toPixels.y(state.mean(1), state.mean(3)),
        Math.sqrt(xxPx2(0)),
        Math.sqrt(yyPx2(0)),
        Math.sqrt(xxPx2(1)),
        Math.sqrt(yyPx2(1)),
        track.events);
  }

  /** The predicted track in metres, where the plane is a road. */
  PlanePoint planePoint() {
    return PlanePoint.of(timeUs, track.id, state);
  }
}
