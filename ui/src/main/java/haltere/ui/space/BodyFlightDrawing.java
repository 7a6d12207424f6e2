package haltere.ui.space;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;
import haltere.filters.orientation.OrientationEstimate;
import haltere.filters.orientation.camera.CameraModel;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Draws a body in space at one time: the way that it has come, its axis with the head, the cone in
 * which the axis lies with 95 % probability, the cameras with what they see, and by how much each
 * saw something else than was expected.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class BodyFlightDrawing {
  private static final int CIRCLE = 36;

  /** A Rayleigh variable is below this times its root mean square with 95 % probability. */
  private static final double WITHIN_95 = 1.73;

  private static final double AXIS_SHARE = 0.12;
  private static final double FRUSTUM_SHARE = 0.15;

  private final BodyFlight flight;
  private final double sizeM;

  /** Draws a flight. */
  public BodyFlightDrawing(BodyFlight flight) {
    this.flight = flight;
    sizeM = SpaceView.sizeM(points(), new double[3]);
  }

  /** All that should be in sight: the cameras and the whole way, metres. */
  public List<double[]> points() {
    List<double[]> points = new ArrayList<>();
    for (CameraModel camera : flight.cameras()) {
      if (camera.problem().isEmpty()) {
        points.add(camera.centre());
      }
    }
    for (BodyFlight.Moment moment : flight.moments()) {
      points.add(place(moment.estimate()));
    }
    return points;
  }

  private static double[] place(OrientationEstimate now) {
    return new double[] {now.xM(), now.yM(), now.zM()};
  }

  /**
   * Draws a moment, counted from 0, onto a canvas whose unit is a pixel, origin at the bottom left.
   */
  public void draw(int index, SpaceView view, OverlayCanvas canvas) {
    BodyFlight.Moment moment = index < flight.moments().size() ? flight.moments().get(index) : null;
    for (int i = 0; i < flight.cameras().size(); i++) {
      if (flight.cameras().get(i).problem().isEmpty()) {
        drawCamera(i, moment, view, canvas);
      }
    }
    if (moment == null) {
      return;
    }
    double[] x = new double[index + 1];
    double[] y = new double[index + 1];
    for (int k = 0; k <= index; k++) {
      double[] at = view.project(place(flight.moments().get(k).estimate()));
      x[k] = at[0];
      y[k] = at[1];
    }
    canvas.polyline(x, y, x.length, MarkStyle.of(Role.PATH, 0));
    drawBody(moment.estimate(), view, canvas);
  }

  private void drawBody(OrientationEstimate now, SpaceView view, OverlayCanvas canvas) {
    double half = AXIS_SHARE * sizeM / 2;
    double[] u = {now.ux(), now.uy(), now.uz()};
    double[] head = {now.xM() + half * u[0], now.yM() + half * u[1], now.zM() + half * u[2]};
    double[] tail = {now.xM() - half * u[0], now.yM() - half * u[1], now.zM() - half * u[2]};
    double[] from = view.project(tail);
    double[] to = view.project(head);
    canvas.line(from[0], from[1], to[0], to[1], MarkStyle.of(Role.ESTIMATE));
    canvas.circle(to[0], to[1], 4, MarkStyle.of(Role.ESTIMATE));
    double wide = half * Math.tan(Math.min(1.2, WITHIN_95 * now.sdAxisRad()));
    double[] side = orthogonal(u);
    double[] other = {
      u[1] * side[2] - u[2] * side[1],
      u[2] * side[0] - u[0] * side[2],
      u[0] * side[1] - u[1] * side[0]
    };
    double[] x = new double[CIRCLE + 1];
    double[] y = new double[CIRCLE + 1];
    double[] middle = view.project(place(now));
    for (int i = 0; i <= CIRCLE; i++) {
      double cos = wide * Math.cos(2 * Math.PI * i / CIRCLE);
      double sin = wide * Math.sin(2 * Math.PI * i / CIRCLE);
      double[] at =
          view.project(
              head[0] + cos * side[0] + sin * other[0],
              head[1] + cos * side[1] + sin * other[1],
              head[2] + cos * side[2] + sin * other[2]);
      x[i] = at[0];
      y[i] = at[1];
      if (i % (CIRCLE / 4) == 0 && i < CIRCLE) {
        canvas.line(middle[0], middle[1], at[0], at[1], MarkStyle.of(Role.UNCERTAINTY));
      }
    }
    canvas.polyline(x, y, x.length, MarkStyle.of(Role.UNCERTAINTY));
    canvas.text(
        to[0] + 8,
        to[1] + 8,
        String.format(Locale.ROOT, "%.1f\u00b0", Math.toDegrees(now.sdAxisRad())),
        MarkStyle.of(Role.LABEL));
  }

  private void drawCamera(
      int index, BodyFlight.Moment moment, SpaceView view, OverlayCanvas canvas) {
    CameraModel camera = flight.cameras().get(index);
    double[] centre = camera.centre();
    double[] corner = view.project(centre);
    double depth = FRUSTUM_SHARE * sizeM;
    double width = camera.widthPx() > 0 ? camera.widthPx() - 1 : 639;
    double height = camera.heightPx() > 0 ? camera.heightPx() - 1 : 479;
    double[] towards = towards(centre);
    double[][] corners = {{0, 0}, {width, 0}, {width, height}, {0, height}};
    double[] x = new double[5];
    double[] y = new double[5];
    double[] sight = new double[3];
    for (int i = 0; i < 5; i++) {
      double[] pixel = corners[i % 4];
      camera.sight(pixel[0], pixel[1], sight);
      double front =
          sight[0] * towards[0] + sight[1] * towards[1] + sight[2] * towards[2] < 0
              ? -depth
              : depth;
      double[] at =
          view.project(
              centre[0] + front * sight[0],
              centre[1] + front * sight[1],
              centre[2] + front * sight[2]);
      x[i] = at[0];
      y[i] = at[1];
      if (i < 4) {
        canvas.line(corner[0], corner[1], at[0], at[1], MarkStyle.of(Role.REGION));
      }
    }
    canvas.polyline(x, y, 5, MarkStyle.of(Role.REGION));
    double residual = moment == null ? Double.NaN : moment.lines().get(index).residualDeg();
    boolean isAccepted = moment != null && moment.lines().get(index).isAccepted();
    String words =
        Double.isNaN(residual)
            ? camera.id()
            : String.format(Locale.ROOT, "%s %+.1f\u00b0", camera.id(), residual);
    canvas.text(
        corner[0] + 6,
        corner[1] + 6,
        words,
        MarkStyle.of(isAccepted || Double.isNaN(residual) ? Role.LABEL : Role.WARNING));
  }

  /** From a camera to the middle of the flight, which is in front of it. */
  private double[] towards(double[] centre) {
    double[] sum = new double[3];
    for (BodyFlight.Moment moment : flight.moments()) {
      double[] at = place(moment.estimate());
      for (int k = 0; k < 3; k++) {
        sum[k] += (at[k] - centre[k]) / flight.moments().size();
      }
    }
    return sum;
  }

  private static double[] orthogonal(double[] u) {
    double level = Math.hypot(u[0], u[1]);
    return level > 1e-9 ? new double[] {-u[1] / level, u[0] / level, 0} : new double[] {1, 0, 0};
  }
}
