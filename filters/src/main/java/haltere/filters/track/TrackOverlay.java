package haltere.filters.track;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.Overlay;
import haltere.core.overlay.OverlayCanvas;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;

/**
 * Draws each track as the ellipse that it is in with 95 % probability, a cross in its middle, the
 * way that it has come, a line to where it would be in a tenth of a second, its identity and, on a
 * road, its speed with its standard deviation; beneath them the marks of the road. Labels come
 * last, on a road those of the nearest first.
 */
public final class TrackOverlay implements Overlay<TrackSnapshot> {
  private static final double VELOCITY_S = 0.1;
  private static final double CROSS_PX = 2;
  private static final double LABEL_PX = 3;

  /** Square root of the chi-square quantile of 0.95 with two degrees of freedom, −2 ln 0.05. */
  private static final double RADII_OF_95_PERCENT = Math.sqrt(-2 * Math.log(0.05));

  @Override
  public void draw(TrackSnapshot snapshot, OverlayCanvas canvas) {
    snapshot.road().ifPresent(road -> RoadDrawing.draw(road, canvas));
    for (TrackSnapshot.Shown track : snapshot.tracks()) {
      drawPath(track.path(), canvas);
      drawPlace(track, canvas);
    }
    snapshot.road().ifPresent(road -> RoadDrawing.drawCounts(road, canvas));
    // A canvas that has no room for all words leaves out those that come last.
    nearestFirst(snapshot).forEach(track -> drawLabel(track, canvas));
  }

  private static void drawPlace(TrackSnapshot.Shown track, OverlayCanvas canvas) {
    TrackPoint now = track.now();
    double x = now.xPx();
    double y = now.yPx();
    MarkStyle style = MarkStyle.of(Role.ESTIMATE, now.id());
    canvas.line(x - CROSS_PX, y, x + CROSS_PX, y, style);
    canvas.line(x, y - CROSS_PX, x, y + CROSS_PX, style);
    drawEllipse(track, canvas);
    canvas.line(
        x,
        y,
        x + VELOCITY_S * now.vxPxS(),
        y + VELOCITY_S * now.vyPxS(),
        MarkStyle.of(Role.VELOCITY, now.id()));
  }

  private static List<TrackSnapshot.Shown> nearestFirst(TrackSnapshot snapshot) {
    return snapshot.road().isEmpty()
        ? snapshot.tracks()
        : snapshot.tracks().stream()
            .sorted(Comparator.comparingDouble(track -> track.now().yPx()))
            .toList();
  }

  private static void drawLabel(TrackSnapshot.Shown track, OverlayCanvas canvas) {
    TrackPoint now = track.now();
    canvas.text(
        now.xPx() + LABEL_PX,
        now.yPx() + LABEL_PX,
        label(track),
        MarkStyle.of(Role.LABEL, now.id()));
  }

  private static String label(TrackSnapshot.Shown track) {
    String id = Integer.toString(track.now().id());
    return Double.isNaN(track.speedKmH())
        ? id
        : id
            + String.format(
                Locale.ROOT, ": %.0f \u00b1 %.0f km/h", track.speedKmH(), track.sdSpeedKmH());
  }

  /** Half axes and direction are the eigenvalues and an eigenvector of the covariance. */
  private static void drawEllipse(TrackSnapshot.Shown track, OverlayCanvas canvas) {
    TrackPoint now = track.now();
    double xx = now.sdXPx() * now.sdXPx();
    double yy = now.sdYPx() * now.sdYPx();
    double xy = track.covarianceXyPx2();
    double mean = (xx + yy) / 2;
    double apart = Math.hypot((xx - yy) / 2, xy);
    double angle = 0.5 * Math.atan2(2 * xy, xx - yy);
    canvas.ellipse(
        now.xPx(),
        now.yPx(),
        RADII_OF_95_PERCENT * Math.sqrt(mean + apart),
        RADII_OF_95_PERCENT * Math.sqrt(Math.max(0, mean - apart)),
        angle,
        MarkStyle.of(track.coasting() ? Role.WARNING : Role.UNCERTAINTY, now.id()));
  }

  private static void drawPath(List<TrackPoint> path, OverlayCanvas canvas) {
    double[] x = new double[path.size()];
    double[] y = new double[path.size()];
    for (int i = 0; i < x.length; i++) {
      x[i] = path.get(i).xPx();
      y[i] = path.get(i).yPx();
    }
    canvas.polyline(x, y, x.length, MarkStyle.of(Role.PATH, path.get(0).id()));
  }
}
