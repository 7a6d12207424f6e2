package haltere.filters.object;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.Overlay;
import haltere.core.overlay.OverlayCanvas;
import java.util.List;

/** Draws each object as one ellipse with its identity, its velocity and its path. */
final class ObjectOverlay implements Overlay<ObjectSnapshot> {
  /** The velocity's line goes to where the object would be in this time, seconds. */
  private static final double VELOCITY_S = 0.1;

  @Override
  public void draw(ObjectSnapshot snapshot, OverlayCanvas canvas) {
    for (List<ObjectTrack> path : snapshot.paths()) {
      ObjectTrack now = path.get(path.size() - 1);
      drawPath(path, canvas);
      canvas.ellipse(
          now.xPx(),
          now.yPx(),
          now.majorPx(),
          now.minorPx(),
          now.angleRad(),
          MarkStyle.of(Role.ESTIMATE, now.id()));
      canvas.line(
          now.xPx(),
          now.yPx(),
          now.xPx() + VELOCITY_S * now.vxPxS(),
          now.yPx() + VELOCITY_S * now.vyPxS(),
          MarkStyle.of(Role.VELOCITY, now.id()));
    }
    for (List<ObjectTrack> path : snapshot.paths()) {
      ObjectTrack now = path.get(path.size() - 1);
      canvas.text(
          now.xPx(), now.yPx(), Integer.toString(now.id()), MarkStyle.of(Role.LABEL, now.id()));
    }
  }

  private static void drawPath(List<ObjectTrack> path, OverlayCanvas canvas) {
    double[] x = path.stream().mapToDouble(ObjectTrack::xPx).toArray();
    double[] y = path.stream().mapToDouble(ObjectTrack::yPx).toArray();
    canvas.polyline(x, y, x.length, MarkStyle.of(Role.PATH, path.get(0).id()));
  }
}
