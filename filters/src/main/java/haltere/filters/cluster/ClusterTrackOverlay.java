package haltere.filters.cluster;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.Overlay;
import haltere.core.overlay.OverlayCanvas;
import java.util.List;

/**
 * Draws each visible cluster as an ellipse with its identity, the path that it has come, and a line
 * to where it would be in a tenth of a second.
 */
public final class ClusterTrackOverlay implements Overlay<ClusterSnapshot> {
  private static final double VELOCITY_S = 0.1;

  @Override
  public void draw(ClusterSnapshot snapshot, OverlayCanvas canvas) {
    for (ClusterSnapshot.Trail trail : snapshot.clusters()) {
      drawPath(trail.path(), canvas);
      ClusterTrack now = trail.now();
      int id = now.id();
      canvas.ellipse(
          now.xPx(),
          now.yPx(),
          now.radiusAlongPx(),
          now.radiusAcrossPx(),
          now.angleRad(),
          MarkStyle.of(Role.OBJECT, id));
      canvas.line(
          now.xPx(),
          now.yPx(),
          now.xPx() + VELOCITY_S * now.vxPxPerS(),
          now.yPx() + VELOCITY_S * now.vyPxPerS(),
          MarkStyle.of(Role.VELOCITY, id));
      double diagonal = now.radiusPx() * Math.sqrt(0.5);
      canvas.text(
          now.xPx() + diagonal,
          now.yPx() + diagonal,
          Integer.toString(id),
          MarkStyle.of(Role.LABEL, id));
    }
  }

  private static void drawPath(List<ClusterTrack> path, OverlayCanvas canvas) {
    double[] x = new double[path.size()];
    double[] y = new double[path.size()];
    for (int i = 0; i < x.length; i++) {
      x[i] = path.get(i).xPx();
      y[i] = path.get(i).yPx();
    }
    canvas.polyline(x, y, x.length, MarkStyle.of(Role.PATH, path.get(0).id()));
  }
}
