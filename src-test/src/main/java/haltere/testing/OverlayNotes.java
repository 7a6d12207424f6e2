package haltere.testing;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.OverlayCanvas;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** A canvas that notes the marks of an overlay as text: role, identity and coordinates. */
public final class OverlayNotes implements OverlayCanvas {
  private final List<String> marks = new ArrayList<>();

  /** No mark yet. */
  public OverlayNotes() {
    // the field is enough
  }

  /**
   * What has been drawn.
   *
   * @return a line for each mark, in order
   */
  public List<String> marks() {
    return List.copyOf(marks);
  }

  private void note(MarkStyle style, String format, Object... values) {
    String mark = String.format(Locale.ROOT, format, values);
    marks.add(style.role() + " " + style.identity() + ": " + mark);
  }

  @Override
  public void circle(double x, double y, double radius, MarkStyle style) {
    note(style, "circle %.1f %.1f radius %.1f", x, y, radius);
  }

  @Override
  public void line(double x1, double y1, double x2, double y2, MarkStyle style) {
    note(style, "line %.1f %.1f to %.1f %.1f", x1, y1, x2, y2);
  }

  @Override
  public void polyline(double[] x, double[] y, int points, MarkStyle style) {
    note(
        style,
        "%s %s",
        Arrays.toString(Arrays.copyOf(x, points)),
        Arrays.toString(Arrays.copyOf(y, points)));
  }

  @Override
  public void ellipse(
      double x, double y, double radiusA, double radiusB, double angleRad, MarkStyle style) {
    note(style, "ellipse %.1f %.1f half axes %.2f %.2f at %.2f", x, y, radiusA, radiusB, angleRad);
  }

  @Override
  public void rectangle(double x, double y, double width, double height, MarkStyle style) {
    note(style, "rectangle %.1f %.1f of %.1f by %.1f", x, y, width, height);
  }

  @Override
  public void text(double x, double y, String text, MarkStyle style) {
    note(style, "%s at %.1f %.1f", text, x, y);
  }
}
