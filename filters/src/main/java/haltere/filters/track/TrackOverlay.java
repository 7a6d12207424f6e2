package haltere.filters.track;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.Overlay;
import haltere.core.overlay.OverlayCanvas;
import java.util.Locale;

/**
 * Draws each track as the ellipse that holds its position with 95 % probability, its path, its
 * velocity as the motion of a tenth of a second, its identity and, on a road, its speed.
 */
public final class TrackOverlay implements Overlay<TrackSnapshot> {
  /** Time whose motion a velocity is drawn as, seconds: short enough to stay in the picture. */
  private static final double VELOCITY_S = 0.1;

  /** Distance of a label from the position, pixels: beside an ellipse of usual size. */
  private static final double LABEL_PX = 3;

  /** Square root of the chi-square quantile of 0.95 with two degrees of freedom, −2 ln 0.05. */
  private static final double RADII_OF_95_PERCENT = Math.sqrt(-2 * Math.log(0.05));

  @Override
  public void draw(TrackSnapshot snapshot, OverlayCanvas canvas) {
    drawAt(snapshot, snapshot.timeUs(), canvas);
  }

  /** {@inheritDoc} Tracks move on with their velocities. */
  @Override
  public void drawAt(TrackSnapshot snapshot, long timeUs, OverlayCanvas canvas) {
    double aheadS = Overlay.aheadS(snapshot.timeUs(), timeUs);
    for (TrackSnapshot.Shown track : snapshot.tracks()) {
      TrackPoint now = track.now();
      double x = now.xPx() + aheadS * now.vxPxS();
      double y = now.yPx() + aheadS * now.vyPxS();
      canvas.polyline(
          track.path().stream().mapToDouble(TrackPoint::xPx).toArray(),
          track.path().stream().mapToDouble(TrackPoint::yPx).toArray(),
          track.path().size(),
          MarkStyle.of(Role.PATH, now.id()));
      drawEllipse(track, x, y, canvas);
      canvas.line(
          x,
          y,
          x + VELOCITY_S * now.vxPxS(),
          y + VELOCITY_S * now.vyPxS(),
          MarkStyle.of(Role.VELOCITY, now.id()));
      canvas.text(x + LABEL_PX, y + LABEL_PX, label(track), MarkStyle.of(Role.LABEL, now.id()));
    }
  }

  private static String label(TrackSnapshot.Shown track) {
    String id = Integer.toString(track.now().id());
    return track
        .onRoad()
        .map(point -> String.format(Locale.ROOT, "%s: %.0f km/h", id, point.speedKmH()))
        .orElse(id);
  }

  /** Half axes and direction are the eigenvalues and an eigenvector of the covariance. */
  private static void drawEllipse(
      TrackSnapshot.Shown track, double x, double y, OverlayCanvas canvas) {
    TrackPoint now = track.now();
    double xx = now.sdXPx() * now.sdXPx();
    double yy = now.sdYPx() * now.sdYPx();
    double xy = track.covarianceXyPx2();
    double mean = (xx + yy) / 2;
    double apart = Math.hypot((xx - yy) / 2, xy);
    canvas.ellipse(
        x,
        y,
        RADII_OF_95_PERCENT * Math.sqrt(mean + apart),
        RADII_OF_95_PERCENT * Math.sqrt(Math.max(0, mean - apart)),
        0.5 * Math.atan2(2 * xy, xx - yy),
        MarkStyle.of(track.coasting() ? Role.WARNING : Role.UNCERTAINTY, now.id()));
  }
}
