package haltere.ui.overlay;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.OverlayCanvas;
import haltere.ui.rendering.MarkColours;
import haltere.ui.rendering.TextPlaces;
import java.util.HashMap;
import java.util.Map;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;
import javafx.scene.shape.StrokeLineCap;
import javafx.scene.shape.StrokeLineJoin;
import javafx.scene.text.Font;

/**
 * Draws marks on a JavaFX canvas that lies over the picture of a sensor.
 *
 * <p>Thread rule: JavaFX thread only.
 */
public final class JavaFxOverlayCanvas implements OverlayCanvas {
  /** Size of words. */
  public static final double FONT_SIZE = 12;

  /** Room around words, units of the screen. */
  private static final double MARGIN = 3;

  private static final double ASCENT = 13;
  private static final double DESCENT = 4;

  private final Font font = Font.font(FONT_SIZE);
  private final TextPlaces positions = new TextPlaces();
  private final TextWidths widths = new TextWidths(font);
  private final GraphicsContext graphics;
  private final Map<Integer, Color> colours = new HashMap<>();
  private double scale = 1;
  private double left;
  private double bottom;
  private boolean dark = true;
  private long marks;

  /** A canvas whose view is yet to be set. */
  public JavaFxOverlayCanvas(GraphicsContext graphics) {
    this.graphics = graphics;
    graphics.setLineCap(StrokeLineCap.ROUND);
    graphics.setLineJoin(StrokeLineJoin.ROUND);
    graphics.setFont(font);
  }

  /** An ARGB colour as JavaFX knows it. */
  public static Color colour(int argb) {
    return Color.rgb(argb >> 16 & 0xFF, argb >> 8 & 0xFF, argb & 0xFF, (argb >>> 24) / 255.0);
  }

  /**
   * Says where the sensor lies: pixels of the screen per pixel of the sensor, its left edge, and
   * its bottom edge from the top of the canvas.
   */
  public void setView(double newScale, double newLeft, double newBottom) {
    scale = newScale;
    left = newLeft;
    bottom = newBottom;
  }

  /** Begins another picture: words may go anywhere again. */
  public void begin() {
    positions.begin(graphics.getCanvas().getWidth(), graphics.getCanvas().getHeight());
  }

  /** Says whether the picture is dark. */
  public void setDark(boolean newDark) {
    dark = newDark;
  }

  /**
   * How many marks were drawn so far, so that the caller can tell whether there is anything to
   * clear.
   */
  public long marks() {
    return marks;
  }

  @Override
  public void polyline(double[] x, double[] y, int points, MarkStyle style) {
    if (points < 2) {
      return;
    }
    stroke(style);
    graphics.beginPath();
    graphics.moveTo(screenX(x[0]), screenY(y[0]));
    for (int i = 1; i < points; i++) {
      graphics.lineTo(screenX(x[i]), screenY(y[i]));
    }
    graphics.stroke();
  }

  @Override
  public void ellipse(
      double x, double y, double radiusA, double radiusB, double angleRad, MarkStyle style) {
    stroke(style);
    double a = radiusA * scale;
    double b = radiusB * scale;
    graphics.save();
    graphics.translate(screenX(x), screenY(y));
    graphics.rotate(-Math.toDegrees(angleRad));
    graphics.strokeOval(-a, -b, 2 * a, 2 * b);
    graphics.restore();
  }

  @Override
  public void text(double x, double y, String text, MarkStyle style) {
    double width = widths.of(text);
    if (!positions.find(screenX(x), screenY(y), width, ASCENT, DESCENT, MARGIN, style)) {
      return;
    }
    marks++;
    double first = positions.left();
    double base = positions.base();
    graphics.setFill(plateColour(dark));
    graphics.fillRect(
        Math.rint(first) - MARGIN, Math.rint(base) - ASCENT, width + 2 * MARGIN, ASCENT + DESCENT);
    graphics.setFill(colour(style));
    graphics.fillText(text, first, base);
  }

  private void stroke(MarkStyle style) {
    marks++;
    graphics.setStroke(colour(style));
    graphics.setLineWidth(MarkColours.width(style));
  }

  private Color plateColour(boolean ofDark) {
    return colours.computeIfAbsent(MarkColours.plate(ofDark), JavaFxOverlayCanvas::colour);
  }

  private Color colour(MarkStyle style) {
    return colours.computeIfAbsent(MarkColours.argb(style, dark), JavaFxOverlayCanvas::colour);
  }

  private double screenX(double x) {
    return left + (x + 0.5) * scale;
  }

  private double screenY(double y) {
    return bottom - (y + 0.5) * scale;
  }
}
