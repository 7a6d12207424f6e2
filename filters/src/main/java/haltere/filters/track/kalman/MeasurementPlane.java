package haltere.filters.track.kalman;

import haltere.filters.track.RoadMapping;
import haltere.filters.track.motion.MotionModes;

/**
 * The plane in which tracks live, and the way to it from pixels: the picture itself, or the road.
 * What a call works out stands in fields until the next call.
 *
 * <p>On the road a measurement is taken in the pixels in which its noise is what it is: it is
 * mapped by the tangent of the map at the place where the track expects it, so that noise of the
 * measurement neither moves the tangent nor picks its own weight.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 */
final class MeasurementPlane {
  private final RoadMapping road;

  /** A mapped measurement. */
  double x;

  double y;
  double xx;
  double xy;
  double yy;

  /** A state in pixels. */
  double xPx;

  double yPx;
  double vxPxS;
  double vyPxS;
  double varianceXPx2;
  double covarianceXyPx2;
  double varianceYPx2;
  double varianceVxPx2S2;
  double varianceVyPx2S2;

  // How pixels change with the place on the road, where that was worked out last.
  private double columnsPerX;
  private double columnsPerY;
  private double rowsPerY;

  /** The picture itself if there is no road. */
  MeasurementPlane(RoadMapping road) {
    this.road = road;
  }

  /** Maps a measurement of which nothing was expected; false if it is not on the plane. */
  boolean map(double zX, double zY, double varianceX, double covariance, double varianceY) {
    if (road == null) {
      set(zX, zY, varianceX, covariance, varianceY);
      return true;
    }
    if (!road.onRoad(zY)) {
      return false;
    }
    double a = road.lateralPerX(zY);
    double b = road.lateralPerY(zX, zY);
    double c = road.distancePerY(zY);
    turn(a, b, c, varianceX, covariance, varianceY);
    x = road.lateralM(zX, zY);
    y = road.distanceM(zY);
    return true;
  }

  /** Maps a measurement that was expected at a place of the plane; false if it is not on it. */
  boolean map(
      MotionModes expected,
      double zX,
      double zY,
      double varianceX,
      double covariance,
      double varianceY) {
    if (road == null) {
      set(zX, zY, varianceX, covariance, varianceY);
      return true;
    }
    double expectedX = expected.x();
    double expectedY = expected.y();
    if (!road.onRoad(zY) || !(expectedY > 0)) {
      return false;
    }
    double column = road.columnOf(expectedX, expectedY);
    double row = road.rowOf(expectedY);
    if (!road.onRoad(row)) {
      return false;
    }
    double a = road.lateralPerX(row);
    double b = road.lateralPerY(column, row);
    double c = road.distancePerY(row);
    turn(a, b, c, varianceX, covariance, varianceY);
    x = expectedX + a * (zX - column) + b * (zY - row);
    y = expectedY + c * (zY - row);
    return true;
  }

  private void set(double zX, double zY, double varianceX, double covariance, double varianceY) {
    x = zX;
    y = zY;
    xx = varianceX;
    xy = covariance;
    yy = varianceY;
  }

  /** J R Jᵀ with J = [a b; 0 c]. */
  private void turn(double a, double b, double c, double r, double s, double t) {
    xx = a * a * r + 2 * a * b * s + b * b * t;
    xy = c * (a * s + b * t);
    yy = c * c * t;
  }

  /** Works out all of a state in pixels; false if it is not in the picture's half of the road. */
  boolean toPixels(MotionModes state) {
    boolean inPicture = toPixels(state, 0);
    if (inPicture) {
      placeSpread(state);
      velocitySpread(state);
    }
    return inPicture;
  }

  /** Place and velocity a time later, if the velocity stays, without how sure they are. */
  boolean toPixels(MotionModes state, double dtS) {
    double laterX = state.x() + dtS * state.vx();
    double laterY = state.y() + dtS * state.vy();
    if (road == null) {
      xPx = laterX;
      yPx = laterY;
      vxPxS = state.vx();
      vyPxS = state.vy();
      return true;
    }
    if (!(laterY > 0)) {
      return false;
    }
    xPx = road.columnOf(laterX, laterY);
    yPx = road.rowOf(laterY);
    if (!road.onRoad(yPx)) {
      return false;
    }
    // The inverse of J = [a b; 0 c] is [1/a −b/(ac); 0 1/c].
    columnsPerX = 1 / road.lateralPerX(yPx);
    rowsPerY = 1 / road.distancePerY(yPx);
    columnsPerY = -road.lateralPerY(xPx, yPx) * columnsPerX * rowsPerY;
    vxPxS = columnsPerX * state.vx() + columnsPerY * state.vy();
    vyPxS = rowsPerY * state.vy();
    return true;
  }

  /** Works out how sure the place of a state is, at the place that was worked out last. */
  void placeSpread(MotionModes state) {
    double p00 = state.covariance(0, 0);
    double p01 = state.covariance(0, 1);
    double p11 = state.covariance(1, 1);
    if (road == null) {
      varianceXPx2 = p00;
      covarianceXyPx2 = p01;
      varianceYPx2 = p11;
      return;
    }
    varianceXPx2 = varianceOfColumn(p00, p01, p11);
    covarianceXyPx2 = rowsPerY * (columnsPerX * p01 + columnsPerY * p11);
    varianceYPx2 = rowsPerY * rowsPerY * p11;
  }

  /** Works out how sure the velocity of a state is, at the place that was worked out last. */
  void velocitySpread(MotionModes state) {
    double p22 = state.covariance(2, 2);
    double p33 = state.covariance(3, 3);
    if (road == null) {
      varianceVxPx2S2 = p22;
      varianceVyPx2S2 = p33;
      return;
    }
    varianceVxPx2S2 = varianceOfColumn(p22, state.covariance(2, 3), p33);
    varianceVyPx2S2 = rowsPerY * rowsPerY * p33;
  }

  private double varianceOfColumn(double ofX, double ofBoth, double ofY) {
    return columnsPerX * columnsPerX * ofX
        + 2 * columnsPerX * columnsPerY * ofBoth
        + columnsPerY * columnsPerY * ofY;
  }
}
