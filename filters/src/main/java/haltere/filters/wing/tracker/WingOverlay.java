package haltere.filters.wing.tracker;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.Overlay;
import haltere.core.overlay.OverlayCanvas;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.WingSnapshot;
import haltere.filters.wing.WingTrackerState;
import java.util.Locale;

/**
 * Draws the body with its heading, the hinges, the region of interest, and the four edges with
 * their standard deviations.
 */
final class WingOverlay implements Overlay<WingSnapshot> {
  private static final double BODY_SHARE = 0.45;
  private static final double BODY_WIDTH_SHARE = 0.15;
  private static final double LETTER_GAP_SHARE = 0.15;
  private static final double HINGE_PX = 1.5;
  private static final double UNCERTAINTY_SD = 2;

  @Override
  public void draw(WingSnapshot snapshot, OverlayCanvas canvas) {
    drawAt(snapshot, snapshot.timeUs(), canvas);
  }

  /** {@inheritDoc} The wings continue their beat. */
  @Override
  public void drawAt(WingSnapshot snapshot, long timeUs, OverlayCanvas canvas) {
    double aheadS = Overlay.aheadS(snapshot.timeUs(), timeUs);
    FlyGeometry fly = snapshot.geometry();
    if (snapshot.phase() == WingTrackerState.Phase.LOST) {
      canvas.text(fly.centreX(), fly.centreY(), "wings lost", MarkStyle.of(Role.WARNING));
      return;
    }
    double heading = fly.headingRad();
    double cos = Math.cos(heading);
    double sin = Math.sin(heading);
    double length = BODY_SHARE * fly.sizePx();
    MarkStyle object = MarkStyle.of(Role.OBJECT);
    canvas.ellipse(
        fly.centreX(), fly.centreY(), length, BODY_WIDTH_SHARE * fly.sizePx(), heading, object);
    canvas.line(
        fly.centreX() - length * cos,
        fly.centreY() - length * sin,
        fly.centreX() + 1.3 * length * cos,
        fly.centreY() + 1.3 * length * sin,
        object);
    canvas.circle(fly.centreX(), fly.centreY(), snapshot.regionPx(), MarkStyle.of(Role.REGION));
    for (int side = 0; side < 2; side++) {
      double x = side == 0 ? fly.leftHingeX() : fly.rightHingeX();
      double y = side == 0 ? fly.leftHingeY() : fly.rightHingeY();
      double turn = side == 0 ? 1 : -1;
      Role role = side == 0 ? Role.LEFT : Role.RIGHT;
      canvas.circle(x, y, HINGE_PX, MarkStyle.of(role));
      double beside = heading + turn * Math.PI / 2;
      double away = snapshot.regionPx() + LETTER_GAP_SHARE * fly.sizePx();
      canvas.text(
          fly.centreX() + away * Math.cos(beside),
          fly.centreY() + away * Math.sin(beside),
          side == 0 ? "L" : "R",
          MarkStyle.of(role));
      double min = Double.POSITIVE_INFINITY;
      double max = Double.NEGATIVE_INFINITY;
      for (int edge = 0; edge < 2; edge++) {
        double angle = snapshot.edgeRad(2 * side + edge, aheadS);
        if (!Double.isNaN(angle)) {
          ray(canvas, x, y, heading + turn * angle, fly.sizePx(), MarkStyle.of(role, edge));
          min = Math.min(min, angle);
          max = Math.max(max, angle);
        }
      }
      double sd = snapshot.sdRad().get(side);
      if (min <= max && !Double.isNaN(sd)) {
        double half = UNCERTAINTY_SD * sd + (max - min) / 2;
        arc(canvas, x, y, heading + turn * (min + max) / 2, half, 0.9 * fly.sizePx());
      }
    }
    canvas.text(
        fly.centreX() + fly.sizePx() * 0.7,
        fly.centreY() + fly.sizePx() * 0.7,
        snapshot.phase() == WingTrackerState.Phase.ONE_WING
            ? "one wing"
            : String.format(Locale.ROOT, "head %.0f %%", 100 * fly.headTailConfidence()),
        MarkStyle.of(Role.LABEL));
  }

  private static void ray(
      OverlayCanvas canvas, double x, double y, double angle, double length, MarkStyle style) {
    canvas.line(x, y, x + length * Math.cos(angle), y + length * Math.sin(angle), style);
  }

  private static void arc(
      OverlayCanvas canvas, double x, double y, double middle, double half, double radius) {
    int points = 9;
    double[] px = new double[points];
    double[] py = new double[points];
    for (int i = 0; i < points; i++) {
      double angle = middle + half * (2.0 * i / (points - 1) - 1);
      px[i] = x + radius * Math.cos(angle);
      py[i] = y + radius * Math.sin(angle);
    }
    canvas.polyline(px, py, points, MarkStyle.of(Role.UNCERTAINTY));
  }
}
