package haltere.ui.rendering;

import haltere.core.event.SensorGeometry;
import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.OverlayCanvas;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;

/**
 * Draws marks on a picture of the sensor that was scaled up by a whole number. Texts are drawn with
 * the built-in {@link PixelFont}, so a picture looks the same on every machine, also where no fonts
 * are installed.
 *
 * <p>Thread rule: one thread at a time. Needs no display.
 */
public final class PictureOverlayCanvas implements OverlayCanvas, AutoCloseable {
  /** Side of a dot of the letters, pixels. */
  private static final int DOT = 2;

  /** Room around words, pixels. */
  private static final int MARGIN = 3;

  private final TextPlaces places = new TextPlaces();
  private final Graphics2D graphics;
  private final int scale;
  private final int height;
  private final boolean dark;

  /**
   * A canvas over a picture.
   *
   * @param image the picture, {@code scale} times the sensor's size
   * @param geometry the sensor
   * @param scale pixels of the picture per pixel of the sensor
   * @param dark whether the picture is dark
   */
  public PictureOverlayCanvas(
      BufferedImage image, SensorGeometry geometry, int scale, boolean dark) {
    places.begin(image.getWidth(), image.getHeight());
    this.graphics = image.createGraphics();
    this.scale = scale;
    this.height = geometry.height();
    this.dark = dark;
    graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
  }

  @Override
  public void line(double x1, double y1, double x2, double y2, MarkStyle style) {
    draw(new Line2D.Double(pictureX(x1), pictureY(y1), pictureX(x2), pictureY(y2)), style);
  }

  @Override
  public void polyline(double[] x, double[] y, int points, MarkStyle style) {
    if (points < 2) {
      return;
    }
    Path2D path = new Path2D.Double();
    path.moveTo(pictureX(x[0]), pictureY(y[0]));
    for (int i = 1; i < points; i++) {
      path.lineTo(pictureX(x[i]), pictureY(y[i]));
    }
    draw(path, style);
  }

  @Override
  public void ellipse(
      double x, double y, double radiusA, double radiusB, double angleRad, MarkStyle style) {
    double a = radiusA * scale;
    double b = radiusB * scale;
    AffineTransform place = AffineTransform.getTranslateInstance(pictureX(x), pictureY(y));
    place.rotate(-angleRad);
    draw(place.createTransformedShape(new Ellipse2D.Double(-a, -b, 2 * a, 2 * b)), style);
  }

  @Override
  public void rectangle(double x, double y, double width, double height, MarkStyle style) {
    draw(
        new Rectangle2D.Double(pictureX(x), pictureY(y + height), width * scale, height * scale),
        style);
  }

  @Override
  public void text(double x, double y, String text, MarkStyle style) {
    double width = PixelFont.width(text, DOT);
    double high = PixelFont.HEIGHT * DOT;
    if (!places.find(pictureX(x), pictureY(y), width, high + MARGIN, MARGIN, MARGIN, style)) {
      return;
    }
    double left = places.left();
    double base = places.base();
    graphics.setColor(new Color(MarkColours.plate(dark), true));
    graphics.fill(
        new Rectangle2D.Double(
            Math.rint(left) - MARGIN,
            Math.rint(base) - high - MARGIN,
            width + 2 * MARGIN,
            high + 2 * MARGIN));
    graphics.setColor(new Color(MarkColours.argb(style, dark), true));
    PixelFont.draw(graphics, text, left, base, DOT);
  }

  private void draw(Shape shape, MarkStyle style) {
    graphics.setColor(new Color(MarkColours.argb(style, dark), true));
    graphics.setStroke(
        new BasicStroke(
            (float) MarkColours.width(style), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    graphics.draw(shape);
  }

  private double pictureX(double x) {
    return (x + 0.5) * scale;
  }

  private double pictureY(double y) {
    return (height - 0.5 - y) * scale;
  }

  @Override
  public void close() {
    graphics.dispose();
  }
}
