package haltere.ui.space;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;
import haltere.core.sink.internal.Ticks;
import haltere.filters.orientation.OrientationEstimate;
import haltere.filters.orientation.camera.CameraModel;
import haltere.filters.orientation.camera.Vectors;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * Draws a body in space at one time: its path, its axis with the head, the 95 % cone of the axis,
 * the cameras with their observations, and the residual of each.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class BodyFlightDrawing {
  private static final int CIRCLE = 36;

  /** A Rayleigh variable is below this times its root mean square with 95 % probability. */
  private static final double WITHIN_95 = 1.73;

  private static final double AXIS_SHARE = 0.12;
  private static final double FRUSTUM_SHARE = 0.15;

  /** Lines of the floor along the longest way through the picture. */
  private static final int FLOOR_LINES = 12;

  /** Shortest scale bar, pixels. */
  private static final double MIN_BAR_PX = 60;

  private static final MarkStyle FLOOR = MarkStyle.of(Role.SCALE);

  private final BodyFlight flight;
  private final SpaceBounds bounds;
  private final double sizeM;

  /** Draws a flight. */
  public BodyFlightDrawing(BodyFlight flight) {
    this.flight = flight;
    bounds = SpaceBounds.of(points());
    sizeM = bounds.diagonalM();
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
    drawFloor(view, canvas);
    drawScale(view, canvas);
    for (int i = 0; i < flight.cameras().size(); i++) {
      if (flight.cameras().get(i).problem().isEmpty()) {
        drawCamera(i, moment, view, canvas);
      }
    }
    if (moment == null) {
      return;
    }
    List<double[]> way =
        flight.moments().subList(0, index + 1).stream()
            .map(each -> view.project(place(each.estimate())))
            .toList();
    polyline(way, MarkStyle.of(Role.PATH, 0), canvas);
    double[] position = place(moment.estimate());
    line(position, new double[] {position[0], position[1], bounds.min()[2]}, view, canvas);
    drawBody(moment.estimate(), view, canvas);
  }

  /** Draws a grid at the lowest height, with the names of its directions. */
  private void drawFloor(SpaceView view, OverlayCanvas canvas) {
    double step = Ticks.of(0, sizeM, FLOOR_LINES).step();
    double height = bounds.min()[2];
    double[] from = new double[2];
    double[] to = new double[2];
    for (int k = 0; k < 2; k++) {
      from[k] = step * Math.floor(bounds.min()[k] / step);
      to[k] = step * Math.max(Math.ceil(bounds.max()[k] / step), from[k] / step + 1);
    }
    for (int k = 0; k < 2; k++) {
      for (long i = Math.round(from[k] / step); i * step <= to[k] + step / 2; i++) {
        double[] begin = {from[0], from[1], height};
        double[] end = {to[0], to[1], height};
        begin[k] = i * step;
        end[k] = i * step;
        line(begin, end, view, canvas);
      }
    }
    double[] endX = view.project(to[0], from[1], height);
    double[] endY = view.project(from[0], to[1], height);
    canvas.text(endX[0], endX[1], "x, squares of " + label(step), MarkStyle.of(Role.LABEL));
    canvas.text(endY[0], endY[1], "y", MarkStyle.of(Role.LABEL));
  }

  private static void line(double[] from, double[] to, SpaceView view, OverlayCanvas canvas) {
    double[] a = view.project(from);
    double[] b = view.project(to);
    canvas.line(a[0], a[1], b[0], b[1], FLOOR);
  }

  private static void polyline(List<double[]> points, MarkStyle style, OverlayCanvas canvas) {
    double[] x = points.stream().mapToDouble(point -> point[0]).toArray();
    double[] y = points.stream().mapToDouble(point -> point[1]).toArray();
    canvas.polyline(x, y, x.length, style);
  }

  /** A bar of a round length at the lower left, for lengths that lie in the picture's plane. */
  private static void drawScale(SpaceView view, OverlayCanvas canvas) {
    double lengthM = Ticks.of(0, MIN_BAR_PX / view.pixelsPerM(), 1).step();
    double lengthPx = lengthM * view.pixelsPerM();
    canvas.line(12, 14, 12 + lengthPx, 14, MarkStyle.of(Role.LABEL));
    for (double end : new double[] {12, 12 + lengthPx}) {
      canvas.line(end, 10, end, 18, MarkStyle.of(Role.LABEL));
    }
    canvas.text(18 + lengthPx, 10, label(lengthM), MarkStyle.of(Role.LABEL));
  }

  private static String label(double lengthM) {
    if (lengthM < 0.01) {
      return String.format(Locale.ROOT, "%.1g mm", lengthM * 1000);
    }
    return lengthM < 1
        ? String.format(Locale.ROOT, "%.0f cm", lengthM * 100)
        : String.format(Locale.ROOT, "%.0f m", lengthM);
  }

  private void drawBody(OrientationEstimate now, SpaceView view, OverlayCanvas canvas) {
    double half = AXIS_SHARE * sizeM / 2;
    double[] u = {now.ux(), now.uy(), now.uz()};
    double[] head = along(place(now), half, u);
    double[] from = view.project(along(place(now), -half, u));
    double[] to = view.project(head);
    canvas.line(from[0], from[1], to[0], to[1], MarkStyle.of(Role.ESTIMATE));
    canvas.circle(to[0], to[1], 4, MarkStyle.of(Role.ESTIMATE));
    double wide = half * Math.tan(Math.min(1.2, WITHIN_95 * now.sdAxisRad()));
    double[] side = Vectors.orthogonalTo(u);
    double[] other = new double[3];
    Vectors.cross(u, side, other);
    List<double[]> circle = new ArrayList<>();
    double[] middle = view.project(place(now));
    for (int i = 0; i <= CIRCLE; i++) {
      double cos = wide * Math.cos(2 * Math.PI * i / CIRCLE);
      double sin = wide * Math.sin(2 * Math.PI * i / CIRCLE);
      double[] at = view.project(along(along(head, cos, side), sin, other));
      circle.add(at);
      if (i % (CIRCLE / 4) == 0 && i < CIRCLE) {
        canvas.line(middle[0], middle[1], at[0], at[1], MarkStyle.of(Role.UNCERTAINTY));
      }
    }
    polyline(circle, MarkStyle.of(Role.UNCERTAINTY), canvas);
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
    List<double[]> picture = new ArrayList<>();
    double[] sight = new double[3];
    for (int i = 0; i < 5; i++) {
      double[] pixel = corners[i % 4];
      camera.lineOfSight(pixel[0], pixel[1], sight);
      double front = Vectors.dot(sight, towards) < 0 ? -depth : depth;
      double[] at = view.project(along(centre, front, sight));
      picture.add(at);
      if (i < 4) {
        canvas.line(corner[0], corner[1], at[0], at[1], MarkStyle.of(Role.REGION));
      }
    }
    polyline(picture, MarkStyle.of(Role.REGION), canvas);
    double residual = moment == null ? Double.NaN : moment.lines().get(index).residualDeg();
    boolean isAccepted = moment != null && moment.lines().get(index).isAccepted();
    String text =
        Double.isNaN(residual)
            ? camera.id()
            : String.format(Locale.ROOT, "%s %+.1f\u00b0", camera.id(), residual);
    canvas.text(
        corner[0] + 6,
        corner[1] + 6,
        text,
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

  private static double[] along(double[] from, double length, double[] direction) {
    double[] point = from.clone();
    Arrays.setAll(point, k -> from[k] + length * direction[k]);
    return point;
  }
}
