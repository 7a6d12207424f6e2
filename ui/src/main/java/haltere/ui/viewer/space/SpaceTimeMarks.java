package haltere.ui.viewer.space;

import haltere.core.event.SensorGeometry;
import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;
import haltere.core.sink.internal.Ticks;
import haltere.ui.rendering.Letters;
import haltere.ui.rendering.SpaceTimeProjection;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Draws marks over events in space and time: the box with three axes, filters' marks in the plane
 * of the newest events, and their traces over time.
 *
 * @param projection where objects lie; (0, 0) of the canvas is the middle of the picture
 * @param sensor columns and rows
 * @param spanUs length of the time axis, microseconds
 * @param letters draws text
 * @param density pixels of the picture per unit of the window
 * @param canvas receives the marks, in pixels of the picture
 */
record SpaceTimeMarks(
    SpaceTimeProjection projection,
    SensorGeometry sensor,
    long spanUs,
    Letters letters,
    double density,
    OverlayCanvas canvas) {
  private static final MarkStyle BOX = MarkStyle.of(Role.SCALE);
  private static final MarkStyle AXIS = MarkStyle.of(Role.LABEL);

  /** Lengths in units of the window. */
  private static final double TICK = 5;

  private static final double TICK_LABEL = 9;
  private static final double NAME = 28;
  private static final double ARROW = 10;
  private static final double PER_TICK = 50;

  /** Of an arrow's sides from its axis, radians. */
  private static final double ARROW_RAD = 0.4;

  /** A quantity along an edge of the box. */
  private enum Axis {
    COLUMN,
    ROW,
    TIME;

    /** A corner of the box, or a point of the edge from it. */
    double[] point(double along, double other, double third) {
      return switch (this) {
        case COLUMN -> new double[] {along, other, third};
        case ROW -> new double[] {other, along, third};
        case TIME -> new double[] {other, third, along};
      };
    }
  }

  private double end(Axis axis) {
    return switch (axis) {
      case COLUMN -> sensor.width() - 1;
      case ROW -> sensor.height() - 1;
      case TIME -> spanUs;
    };
  }

  /** Room for ticks and names at each side of the box, units of the window. */
  static double room() {
    return NAME;
  }

  /** Draws the twelve edges of the box, three of them with ticks and names. */
  void drawAxes() {
    List<double[]> zeros = new ArrayList<>();
    draw(Axis.COLUMN, Axis.ROW, Axis.TIME, zeros);
    draw(Axis.ROW, Axis.COLUMN, Axis.TIME, zeros);
    draw(Axis.TIME, Axis.COLUMN, Axis.ROW, zeros);
  }

  private void draw(Axis axis, Axis other, Axis third, List<double[]> zeros) {
    Edge labelled = null;
    for (double a : new double[] {0, end(other)}) {
      for (double b : new double[] {0, end(third)}) {
        Edge edge = new Edge(axis, a, b, project(axis.point(0, a, b)), end(axis, a, b));
        canvas.line(edge.from[0], edge.from[1], edge.to[0], edge.to[1], BOX);
        // row labels at the left, column and time labels below
        int coordinate = axis == Axis.ROW ? 0 : 1;
        if (labelled == null || edge.middle(coordinate) < labelled.middle(coordinate)) {
          labelled = edge;
        }
      }
    }
    if (labelled.length() >= PER_TICK * density) {
      drawScale(labelled, zeros);
    }
  }

  private double[] end(Axis axis, double other, double third) {
    return project(axis.point(end(axis), other, third));
  }

  private double[] project(double[] point) {
    return new double[] {
      projection.across(point[0], point[2]), projection.up(point[0], point[1], point[2])
    };
  }

  /** An edge of the box in the picture. */
  private record Edge(Axis axis, double other, double third, double[] from, double[] to) {
    double middle(int coordinate) {
      return (from[coordinate] + to[coordinate]) / 2;
    }

    double length() {
      return Math.hypot(to[0] - from[0], to[1] - from[1]);
    }

    /** Direction across the edge, away from the middle of the picture. */
    double[] outward() {
      double x = (to[1] - from[1]) / length();
      double y = (from[0] - to[0]) / length();
      double sign = x * middle(0) + y * middle(1) < 0 ? -1 : 1;
      return new double[] {sign * x, sign * y};
    }
  }

  /** Draws ticks and names along an edge; axes with a common corner share its label 0. */
  private void drawScale(Edge edge, List<double[]> zeros) {
    boolean isTime = edge.axis == Axis.TIME;
    double unitUs = spanUs < 5_000 ? 1 : spanUs < 2_000_000 ? 1_000 : 1_000_000;
    double unit = isTime ? unitUs : 1;
    double end = end(edge.axis) / unit;
    int maxTicks = (int) Math.max(2, edge.length() / (PER_TICK * density));
    Ticks ticks = isTime ? Ticks.of(-end, 0, maxTicks) : Ticks.atLeastTwo(0, end, maxTicks);
    double[] outward = edge.outward();
    canvas.line(edge.from[0], edge.from[1], edge.to[0], edge.to[1], AXIS);
    for (double value : ticks.values()) {
      double[] at = project(edge.axis.point(Math.abs(value) * unit, edge.other, edge.third));
      double x = at[0] + outward[0] * TICK * density;
      double y = at[1] + outward[1] * TICK * density;
      canvas.line(at[0], at[1], x, y, AXIS);
      if (value == 0 && zeros.stream().anyMatch(zero -> Arrays.equals(zero, at))) {
        continue;
      }
      text(ticks.label(value), at, outward, TICK_LABEL);
      if (value == 0) {
        zeros.add(at);
      }
    }
    double[] middle = {edge.middle(0), edge.middle(1)};
    if (isTime) {
      String name = unitUs == 1 ? "\u00b5s" : unitUs == 1_000 ? "ms" : "s";
      text("time, " + name, middle, outward, NAME);
      drawArrow(edge);
    } else {
      text(edge.axis == Axis.COLUMN ? "x, px" : "y, px", middle, outward, NAME);
    }
  }

  /** Time runs to the newest events. */
  private void drawArrow(Edge edge) {
    double back = Math.atan2(edge.to[1] - edge.from[1], edge.to[0] - edge.from[0]);
    for (int side = -1; side <= 1; side += 2) {
      canvas.line(
          edge.from[0],
          edge.from[1],
          edge.from[0] + ARROW * density * Math.cos(back + side * ARROW_RAD),
          edge.from[1] + ARROW * density * Math.sin(back + side * ARROW_RAD),
          AXIS);
    }
  }

  /** Words beside a point, at a distance from it. */
  private void text(String label, double[] at, double[] outward, double distance) {
    double halfWidth = letters.width(label) / 2;
    double halfHeight = letters.ascent() / 2;
    double x = at[0] + outward[0] * (distance * density + halfWidth);
    double y = at[1] + outward[1] * (distance * density + halfHeight);
    canvas.text(x - halfWidth, y - halfHeight, label, AXIS);
  }

  /** Draws marks and traces of a moment. */
  void draw(SpaceTimeSink.Frame frame) {
    for (MarkTraces.Trace trace : frame.traces) {
      double[] x = new double[trace.positions().size()];
      double[] y = new double[x.length];
      int i = 0;
      for (MarkTraces.TracePoint at : trace.positions()) {
        double[] place = project(new double[] {at.x(), at.y(), frame.nowUs - at.timeUs()});
        x[i] = place[0];
        y[i++] = place[1];
      }
      canvas.polyline(x, y, x.length, trace.style());
    }
    frame.marks.forEach(marks -> marks.draw(frame.nowUs, new Plane()));
  }

  /** The plane of the newest events, on which marks lie as on the sensor. */
  private final class Plane implements OverlayCanvas {
    @Override
    public void polyline(double[] x, double[] y, int points, MarkStyle style) {
      double[] across = new double[points];
      double[] up = new double[points];
      for (int i = 0; i < points; i++) {
        across[i] = projection.across(x[i], 0);
        up[i] = projection.up(x[i], y[i], 0);
      }
      canvas.polyline(across, up, points, style);
    }

    @Override
    public void text(double x, double y, String text, MarkStyle style) {
      canvas.text(projection.across(x, 0), projection.up(x, y, 0), text, style);
    }
  }
}
