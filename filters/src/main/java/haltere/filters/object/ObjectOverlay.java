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
    drawAt(snapshot, snapshot.timeUs(), canvas);
  }

  /** {@inheritDoc} Objects move on with their velocities. */
  @Override
  public void drawAt(ObjectSnapshot snapshot, long timeUs, OverlayCanvas canvas) {
    double aheadS = Overlay.aheadS(snapshot.timeUs(), timeUs);
    for (List<ObjectTrack> path : snapshot.paths()) {
      ObjectTrack now = path.get(path.size() - 1);
      double x = now.xPx() + aheadS * now.vxPxS();
      double y = now.yPx() + aheadS * now.vyPxS();
      drawPath(path, canvas);
      canvas.ellipse(
          x,
          y,
          now.majorPx(),
          now.minorPx(),
          now.angleRad(),
          MarkStyle.of(Role.ESTIMATE, now.id()));
      canvas.line(
          x,
          y,
          x + VELOCITY_S * now.vxPxS(),
          y + VELOCITY_S * now.vyPxS(),
          MarkStyle.of(Role.VELOCITY, now.id()));
    }
    for (List<ObjectTrack> path : snapshot.paths()) {
      ObjectTrack now = path.get(path.size() - 1);
      canvas.text(
          now.xPx() + aheadS * now.vxPxS(),
          now.yPx() + aheadS * now.vyPxS(),
          Integer.toString(now.id()),
          MarkStyle.of(Role.LABEL, now.id()));
    }
  }

  private static void drawPath(List<ObjectTrack> path, OverlayCanvas canvas) {
    double[] x = path.stream().mapToDouble(ObjectTrack::xPx).toArray();
    double[] y = path.stream().mapToDouble(ObjectTrack::yPx).toArray();
    canvas.polyline(x, y, x.length, MarkStyle.of(Role.PATH, path.get(0).id()));
  }
}
