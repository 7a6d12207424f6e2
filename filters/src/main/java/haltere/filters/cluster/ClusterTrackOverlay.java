package haltere.filters.cluster;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.Overlay;
import haltere.core.overlay.OverlayCanvas;

/**
 * Draws each visible cluster as its box or ellipse with its identity, its path, and its velocity as
 * the motion of a tenth of a second.
 */
public final class ClusterTrackOverlay implements Overlay<ClusterSnapshot> {
  /** Time whose motion a velocity is drawn as, seconds: short enough to stay in the picture. */
  private static final double VELOCITY_S = 0.1;

  @Override
  public void draw(ClusterSnapshot snapshot, OverlayCanvas canvas) {
    drawAt(snapshot, snapshot.timeUs(), canvas);
  }

  /** {@inheritDoc} Clusters move on with their velocities. */
  @Override
  public void drawAt(ClusterSnapshot snapshot, long timeUs, OverlayCanvas canvas) {
    double aheadS = Overlay.aheadS(snapshot.timeUs(), timeUs);
    for (ClusterSnapshot.Trail trail : snapshot.clusters()) {
      ClusterTrack now = trail.now();
      int id = now.id();
      double x = now.xPx() + aheadS * now.vxPxPerS();
      double y = now.yPx() + aheadS * now.vyPxPerS();
      canvas.polyline(
          trail.path().stream().mapToDouble(ClusterTrack::xPx).toArray(),
          trail.path().stream().mapToDouble(ClusterTrack::yPx).toArray(),
          trail.path().size(),
          MarkStyle.of(Role.PATH, id));
      drawShape(snapshot.type(), now, x, y, canvas);
      canvas.line(
          x,
          y,
          x + VELOCITY_S * now.vxPxPerS(),
          y + VELOCITY_S * now.vyPxPerS(),
          MarkStyle.of(Role.VELOCITY, id));
      double diagonal = now.radiusPx() * Math.sqrt(0.5);
      canvas.text(x + diagonal, y + diagonal, Integer.toString(id), MarkStyle.of(Role.LABEL, id));
    }
  }

  private static void drawShape(
      ClusterShapeSettings.Type type,
      ClusterTrack track,
      double centreX,
      double centreY,
      OverlayCanvas canvas) {
    MarkStyle style = MarkStyle.of(Role.OBJECT, track.id());
    double a = track.radiusAlongPx();
    double b = track.radiusAcrossPx();
    if (type == ClusterShapeSettings.Type.ELLIPSE) {
      canvas.ellipse(centreX, centreY, a, b, track.angleRad(), style);
      return;
    }
    double cos = Math.cos(track.angleRad());
    double sin = Math.sin(track.angleRad());
    double[] along = {a, -a, -a, a, a};
    double[] across = {b, b, -b, -b, b};
    double[] x = new double[along.length];
    double[] y = new double[along.length];
    for (int i = 0; i < along.length; i++) {
      x[i] = centreX + cos * along[i] - sin * across[i];
      y[i] = centreY + sin * along[i] + cos * across[i];
    }
    canvas.polyline(x, y, x.length, style);
  }
}
