package haltere.filters.track;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;

/**
 * Draws the marks of a road: a cross where it vanishes, the borders of the lanes, and the counting
 * lines.
 */
final class RoadDrawing {
  private static final MarkStyle MARK = MarkStyle.of(Role.REGION);
  private static final double CROSS_PX = 4;
  private static final double ROWS_APART = 2;
  private static final double LABEL_PX = 1;

  private RoadDrawing() {}

  static void draw(RoadMarks marks, OverlayCanvas canvas) {
    double x = marks.mapping().vanishingX();
    double y = marks.mapping().vanishingY();
    canvas.line(x - CROSS_PX, y, x + CROSS_PX, y, MARK);
    canvas.line(x, y - CROSS_PX, x, y + CROSS_PX, MARK);
    LaneSettings lanes = marks.lanes();
    for (int i = 0; lanes.lanes() > 0 && i <= lanes.lanes(); i++) {
      drawBorder(marks, lanes.leftEdgeM() + i * lanes.widthM(), canvas);
    }
    for (RoadMarks.Line line : marks.lines()) {
      if (isInPicture(marks, line)) {
        double row = marks.mapping().rowOf(line.distanceM());
        canvas.line(leftOf(marks, line), row, rightOf(marks, line), row, MARK);
      }
    }
  }

  /** The distance of each counting line, and how many went up and down the picture there. */
  static void drawCounts(RoadMarks marks, OverlayCanvas canvas) {
    for (RoadMarks.Line line : marks.lines()) {
      if (isInPicture(marks, line)) {
        double row = marks.mapping().rowOf(line.distanceM());
        String text =
            Math.round(line.distanceM()) + " m \u2191" + line.away() + " \u2193" + line.towards();
        canvas.text(leftOf(marks, line), row + LABEL_PX, text, MARK);
      }
    }
  }

  /** A line along the road, as far as it is in the picture. */
  private static void drawBorder(RoadMarks marks, double lateralM, OverlayCanvas canvas) {
    RoadMapping mapping = marks.mapping();
    int most = 1 + (int) (Math.min(mapping.vanishingY(), marks.sensor().height()) / ROWS_APART);
    double[] x = new double[most];
    double[] y = new double[most];
    int points = 0;
    for (int i = 0; i < most; i++) {
      double row = i * ROWS_APART;
      if (mapping.onRoad(row)) {
        double column = mapping.columnOf(lateralM, mapping.distanceM(row));
        if (column >= 0 && column <= marks.sensor().width() - 1) {
          x[points] = column;
          y[points++] = row;
        }
      }
    }
    if (points > 1) {
      canvas.polyline(x, y, points, MARK);
    }
  }

  private static boolean isInPicture(RoadMarks marks, RoadMarks.Line line) {
    double row = marks.mapping().rowOf(line.distanceM());
    return marks.mapping().onRoad(row) && row >= 0 && row <= marks.sensor().height() - 1;
  }

  private static double leftOf(RoadMarks marks, RoadMarks.Line line) {
    LaneSettings lanes = marks.lanes();
    return lanes.lanes() == 0 ? 0 : columnOf(marks, lanes.leftEdgeM(), line);
  }

  private static double rightOf(RoadMarks marks, RoadMarks.Line line) {
    LaneSettings lanes = marks.lanes();
    return lanes.lanes() == 0
        ? marks.sensor().width() - 1
        : columnOf(marks, lanes.rightEdgeM(), line);
  }

  private static double columnOf(RoadMarks marks, double lateralM, RoadMarks.Line line) {
    double column = marks.mapping().columnOf(lateralM, line.distanceM());
    return Math.min(marks.sensor().width() - 1, Math.max(0, column));
  }
}
