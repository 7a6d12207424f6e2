package haltere.ui.rendering;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.OverlayCanvas;
import java.awt.geom.Rectangle2D;
import java.util.Optional;

/** Draws marks into the pixels of a picture in screen resolution. */
public final class PixelOverlayCanvas implements OverlayCanvas {
  /** Most corners of an ellipse. */
  private static final int CORNERS = 64;

  /** Corners for each root of a pixel of the radius, which are off by a tenth of a pixel. */
  private static final double CORNERS_PER_ROOT = 7;

  /** Points of a path that are nearer to the one before, in pixels, are left out. */
  private static final double MIN_STEP = 1;

  /** Margin around text, units of the view. */
  private static final double MARGIN = 3;

  private final LinePainter painter = new LinePainter();
  private final TextPositions positions = new TextPositions();
  private final Letters letters;
  private double density = 1;
  private double scale = 1;
  private double left;
  private double bottom;
  private boolean dark = true;

  /** A canvas without pixels, with the letters of its text. */
  public PixelOverlayCanvas(Letters letters) {
    this.letters = letters;
  }

  /**
   * Sets the target, opaque pixels row by row from the top; all positions are free for text again.
   */
  public void setTarget(int[] pixels, int newWidth, int newHeight) {
    painter.setTarget(pixels, newWidth, newHeight);
    positions.begin(newWidth, newHeight);
  }

  /**
   * Sets the position of the sensor: units of the view per pixel of the sensor, its left edge and
   * its bottom edge in units from the left and the top, and pixels per unit of the view.
   */
  public void setView(double newScale, double newLeft, double newBottom, double newDensity) {
    density = newDensity;
    scale = newScale * density;
    left = newLeft * density;
    bottom = newBottom * density;
  }

  /** Says whether the picture is dark. */
  public void setDark(boolean newDark) {
    dark = newDark;
  }

  @Override
  public void circle(double x, double y, double radius, MarkStyle style) {
    painter.ring(pixelX(x), pixelY(y), radius * scale, thickness(style), argb(style));
  }

  @Override
  public void line(double x1, double y1, double x2, double y2, MarkStyle style) {
    painter.line(
        pixelX(x1), pixelY(y1), pixelX(x2), pixelY(y2), thickness(style), argb(style), true);
  }

  @Override
  public void polyline(double[] x, double[] y, int points, MarkStyle style) {
    double fromX = points > 0 ? pixelX(x[0]) : 0;
    double fromY = points > 0 ? pixelY(y[0]) : 0;
    for (int i = 1; i < points; i++) {
      double toX = pixelX(x[i]);
      double toY = pixelY(y[i]);
      // the path of a slow object has many points in a pixel
      if (i == points - 1 || Math.abs(toX - fromX) + Math.abs(toY - fromY) >= MIN_STEP) {
        segment(fromX, fromY, toX, toY, style);
        fromX = toX;
        fromY = toY;
      }
    }
  }

  /** Without round ends, so that translucent lines are not drawn twice where they meet. */
  private void segment(double x1, double y1, double x2, double y2, MarkStyle style) {
    painter.line(x1, y1, x2, y2, thickness(style), argb(style), false);
  }

  @Override
  public void ellipse(
      double x, double y, double radiusA, double radiusB, double angleRad, MarkStyle style) {
    double larger = Math.max(radiusA, radiusB) * scale;
    int corners = Math.max(8, (int) Math.min(CORNERS, CORNERS_PER_ROOT * Math.sqrt(larger)));
    double cos = Math.cos(angleRad);
    double sin = Math.sin(angleRad);
    double[] cornersX = new double[corners + 1];
    double[] cornersY = new double[corners + 1];
    for (int i = 0; i <= corners; i++) {
      double turnRad = 2 * Math.PI * (i % corners) / corners;
      double a = radiusA * Math.cos(turnRad);
      double b = radiusB * Math.sin(turnRad);
      cornersX[i] = x + a * cos - b * sin;
      cornersY[i] = y + a * sin + b * cos;
    }
    polyline(cornersX, cornersY, corners + 1, style);
  }

  @Override
  public void rectangle(double x, double y, double rectWidth, double rectHeight, MarkStyle style) {
    double west = pixelX(x);
    double east = pixelX(x + rectWidth);
    double south = pixelY(y);
    double north = pixelY(y + rectHeight);
    double half = thickness(style) / 2;
    segment(west - half, north, east + half, north, style);
    segment(west - half, south, east + half, south, style);
    segment(west, north + half, west, south - half, style);
    segment(east, north + half, east, south - half, style);
  }

  @Override
  public void text(double x, double y, String text, MarkStyle style) {
    double margin = MARGIN * density;
    double textWidth = letters.width(text);
    double ascent = letters.ascent();
    double descent = letters.descent();
    Optional<Rectangle2D> plate =
        positions.find(pixelX(x), pixelY(y), textWidth, ascent, descent, margin, style);
    if (plate.isEmpty()) {
      return;
    }
    int from = (int) Math.rint(plate.get().getX() + margin);
    int base = (int) Math.rint(plate.get().getY() + ascent);
    painter.fill(
        (int) Math.rint(from - margin),
        (int) Math.rint(base - ascent),
        (int) Math.rint(from + textWidth + margin),
        (int) Math.rint(base + descent),
        MarkColours.plate(dark));
    int argb = argb(style);
    letters.draw(text, from, base, (column, row, share) -> painter.dot(column, row, argb, share));
  }

  private int argb(MarkStyle style) {
    return MarkColours.argb(style, dark);
  }

  private double thickness(MarkStyle style) {
    return MarkColours.width(style) * density;
  }

  private double pixelX(double x) {
    return left + (x + 0.5) * scale;
  }

  private double pixelY(double y) {
    return bottom - (y + 0.5) * scale;
  }
}
