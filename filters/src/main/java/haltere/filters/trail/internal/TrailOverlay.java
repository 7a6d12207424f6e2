package haltere.filters.trail.internal;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.Overlay;
import haltere.core.overlay.OverlayCanvas;
import haltere.filters.trail.TrailPoint;

/**
 * Draws each object as its outline with its label, its path, and its velocity as the motion of a
 * tenth of a second.
 */
public final class TrailOverlay implements Overlay<TrailSnapshot> {
  /** Corners of a box in units of its half axes. */
  private static final int[][] CORNERS = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 1}};

  @Override
  public void draw(TrailSnapshot snapshot, OverlayCanvas canvas) {
    drawAt(snapshot, snapshot.timeUs(), canvas);
  }

  /** {@inheritDoc} Objects move on with their velocities. */
  @Override
  public void drawAt(TrailSnapshot snapshot, long timeUs, OverlayCanvas canvas) {
    double aheadS = Overlay.aheadS(snapshot.timeUs(), timeUs);
    for (TrailSnapshot.Trail trail : snapshot.trails()) {
      TrailPoint now = trail.now();
      TrailMark mark = trail.mark();
      double x = now.xPx() + aheadS * now.vxPxS();
      double y = now.yPx() + aheadS * now.vyPxS();
      double[] pathX = trail.path().stream().mapToDouble(TrailPoint::xPx).toArray();
      double[] pathY = trail.path().stream().mapToDouble(TrailPoint::yPx).toArray();
      canvas.polyline(pathX, pathY, pathX.length, MarkStyle.of(Role.PATH, now.id()));
      drawOutline(mark, x, y, canvas, now.id());
      canvas.line(
          x,
          y,
          x + MAX_AHEAD_S * now.vxPxS(),
          y + MAX_AHEAD_S * now.vyPxS(),
          MarkStyle.of(Role.VELOCITY, now.id()));
      canvas.text(
          x + mark.labelPx(), y + mark.labelPx(), mark.label(), MarkStyle.of(Role.LABEL, now.id()));
    }
  }

  private static void drawOutline(
      TrailMark mark, double centreX, double centreY, OverlayCanvas canvas, int id) {
    MarkStyle style = MarkStyle.of(mark.role(), id);
    double a = mark.outline().majorPx();
    double b = mark.outline().minorPx();
    double angle = mark.outline().angleRad();
    if (!mark.isBox()) {
      canvas.ellipse(centreX, centreY, a, b, angle, style);
      return;
    }
    double[] x = new double[CORNERS.length];
    double[] y = new double[CORNERS.length];
    for (int i = 0; i < CORNERS.length; i++) {
      double along = a * CORNERS[i][0];
      double across = b * CORNERS[i][1];
      x[i] = centreX + Math.cos(angle) * along - Math.sin(angle) * across;
      y[i] = centreY + Math.sin(angle) * along + Math.cos(angle) * across;
    }
    canvas.polyline(x, y, x.length, style);
  }
}
