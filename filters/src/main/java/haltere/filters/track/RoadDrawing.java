package haltere.filters.track;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;

/**
 * Draws the marks of a road: a cross where it vanishes, the borders of the lanes, and the counting
 * lines with their distance and how many went up and down the picture there.
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
      drawLine(marks, line, canvas);
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

  private static void drawLine(RoadMarks marks, RoadMarks.Line line, OverlayCanvas canvas) {
    RoadMapping mapping = marks.mapping();
    double row = mapping.rowOf(line.distanceM());
    if (!mapping.onRoad(row) || row < 0 || row > marks.sensor().height() - 1) {
      return;
    }
    LaneSettings lanes = marks.lanes();
    double right = marks.sensor().width() - 1;
    double from = 0;
    double to = right;
    if (lanes.lanes() > 0) {
      double leftM = lanes.leftEdgeM();
      double rightM = leftM + lanes.lanes() * lanes.widthM();
      from = Math.min(right, Math.max(0, mapping.columnOf(leftM, line.distanceM())));
      to = Math.min(right, Math.max(0, mapping.columnOf(rightM, line.distanceM())));
    }
    canvas.line(from, row, to, row, MARK);
    String text =
        Math.round(line.distanceM()) + " m \u2191" + line.away() + " \u2193" + line.towards();
    canvas.text(from, row + LABEL_PX, text, MARK);
  }
}
