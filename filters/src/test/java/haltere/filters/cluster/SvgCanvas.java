package haltere.filters.cluster;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.OverlayCanvas;
import java.util.Locale;

/** Draws events and marks as a picture for the documentation. */
final class SvgCanvas implements OverlayCanvas {
  private static final String[] COLOURS = {
    "#1f6fb4", "#c23b22", "#2f8f4e", "#8a4fb0", "#b8860b", "#008b8b", "#d2468c", "#5a5a5a"
  };

  private final SensorGeometry geometry;
  private final StringBuilder marks = new StringBuilder();

  SvgCanvas(SensorGeometry geometry) {
    this.geometry = geometry;
  }

  void events(EventPacket events, int from) {
    for (int i = from; i < events.size(); i++) {
      add(
          "<rect x=\"%d\" y=\"%d\" width=\"1\" height=\"1\" fill=\"%s\"/>%n",
          events.x(i), geometry.height() - 1 - events.y(i), events.isOn(i) ? "#e09030" : "#6090d0");
    }
  }

  String svg() {
    return String.format(
        Locale.ROOT,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\""
            + " height=\"%d\">%n"
            + "<rect width=\"100%%\" height=\"100%%\" fill=\"#f7f7f4\"/>%n%s</svg>%n",
        geometry.width(),
        geometry.height(),
        3 * geometry.width(),
        3 * geometry.height(),
        marks);
  }

  private void add(String format, Object... values) {
    marks.append(String.format(Locale.ROOT, format, values));
  }

  private double up(double y) {
    return geometry.height() - 0.5 - y;
  }

  private static String stroke(MarkStyle style) {
    return "fill=\"none\" stroke=\""
        + COLOURS[Math.floorMod(style.identity(), COLOURS.length)]
        + "\" stroke-width=\"0.6\"";
  }

  @Override
  public void circle(double x, double y, double radius, MarkStyle style) {
    ellipse(x, y, radius, radius, 0, style);
  }

  @Override
  public void line(double x1, double y1, double x2, double y2, MarkStyle style) {
    polyline(new double[] {x1, x2}, new double[] {y1, y2}, 2, style);
  }

  @Override
  public void polyline(double[] x, double[] y, int points, MarkStyle style) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < points; i++) {
      text.append(String.format(Locale.ROOT, "%.1f,%.1f ", x[i] + 0.5, up(y[i])));
    }
    add("<polyline points=\"%s\" %s/>%n", text.toString().trim(), stroke(style));
  }

  @Override
  public void ellipse(
      double x, double y, double radiusA, double radiusB, double angleRad, MarkStyle style) {
    add(
        "<ellipse cx=\"%.1f\" cy=\"%.1f\" rx=\"%.1f\" ry=\"%.1f\"",
        x + 0.5, up(y), radiusA, radiusB);
    if (radiusA != radiusB) {
      add(" transform=\"rotate(%.0f %.1f %.1f)\"", -Math.toDegrees(angleRad), x + 0.5, up(y));
    }
    add(" %s/>%n", stroke(style));
  }

  @Override
  public void rectangle(double x, double y, double width, double height, MarkStyle style) {
    polyline(
        new double[] {x, x + width, x + width, x, x},
        new double[] {y, y, y + height, y + height, y},
        5,
        style);
  }

  @Override
  public void text(double x, double y, String text, MarkStyle style) {
    add(
        "<text x=\"%.1f\" y=\"%.1f\" font-size=\"7\" font-family=\"sans-serif\" fill=\"%s\">%s"
            + "</text>%n",
        x + 0.5, up(y), COLOURS[Math.floorMod(style.identity(), COLOURS.length)], text);
  }
}
