package haltere.core.sink.internal;

import java.io.IOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;

/**
 * A plot of a few lines, bands and dots as SVG. The same numbers result in the same bytes on any
 * machine, independent of its fonts. NaN points are omitted.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class SvgPlot {
  /** Maximum number of ticks on an axis. */
  private static final int MAX_TICKS = 11;

  private static final int WIDTH = 640;
  private static final int HEIGHT = 300;
  private static final int MIN_LEFT = 60;

  /** Space for the vertical label and the gaps beside the numbers. */
  private static final int LEFT_GAPS = 24;

  /** Width of a digit in a usual sans-serif font. */
  private static final int DIGIT_WIDTH = 7;

  private static final int RIGHT = 12;
  private static final int TOP = 28;
  private static final int BOTTOM = 42;

  /** Height of the row with the names of the lines. */
  private static final int LEGEND = 16;

  /** Space between two names. */
  private static final int NAME_GAP = 14;

  /** Longest number below the plot that leaves a gap to the next one, in characters. */
  private static final int MAX_DIGITS = 8;

  private final double fromX;
  private final double toX;
  private final double fromY;
  private final double toY;

  /** Width of the margin with the numbers of the vertical axis. */
  private final int left;

  private final StringBuilder marks = new StringBuilder();
  private final List<String> names = new ArrayList<>();
  private final List<String> colours = new ArrayList<>();
  private boolean wholeX;

  /**
   * A plot of a range.
   *
   * @param fromX left edge
   * @param toX right edge, more than the left
   * @param fromY lower edge
   * @param toY upper edge, more than the lower
   */
  public SvgPlot(double fromX, double toX, double fromY, double toY) {
    this.fromX = fromX;
    this.toX = toX;
    this.fromY = fromY;
    this.toY = toY;
    Ticks up = Ticks.of(fromY, toY, MAX_TICKS);
    int digits = up.values().stream().mapToInt(y -> up.label(y).length()).max().orElse(0);
    left = Math.max(MIN_LEFT, LEFT_GAPS + DIGIT_WIDTH * digits);
  }

  /**
   * A plot whose range holds all points, with a margin of a twentieth above and below.
   *
   * @param x finite, at least one
   * @param ys of several lines; entries that are not finite are omitted
   * @return an empty plot
   */
  public static SvgPlot around(double[] x, double[]... ys) {
    DoubleSummaryStatistics across = Arrays.stream(x).summaryStatistics();
    DoubleSummaryStatistics up =
        Arrays.stream(ys)
            .flatMapToDouble(Arrays::stream)
            .filter(Double::isFinite)
            .summaryStatistics();
    double min = up.getCount() == 0 ? 0 : up.getMin();
    double max = up.getCount() == 0 ? 0 : up.getMax();
    double margin = max > min ? (max - min) / 20 : 1;
    double width = across.getMax() - across.getMin();
    return new SvgPlot(
        across.getMin(),
        width > 0 ? across.getMax() : across.getMin() + 1,
        min - margin,
        max + margin);
  }

  /**
   * Labels whole numbers of the horizontal axis alone.
   *
   * @return this plot
   */
  public SvgPlot wholeX() {
    wholeX = true;
    return this;
  }

  /**
   * A line through points; those outside the range are cut off at its edge. A lone point is a dot.
   *
   * @param name for the legend, empty for none
   * @param colour as SVG has it
   * @param x as many as y
   * @param y values
   * @return this plot
   */
  public SvgPlot line(String name, String colour, double[] x, double[] y) {
    String points = points(x, y);
    if (points.indexOf(' ') < 0) {
      return dots(name, colour, x, y);
    }
    marks.append("<polyline fill=\"none\" stroke-width=\"1.5\" stroke=\"");
    marks.append(colour).append("\" points=\"").append(points).append("\"/>\n");
    return named(name, colour);
  }

  /**
   * A band between two lines.
   *
   * @param name for the legend, empty for none
   * @param colour as SVG has it
   * @param x as many as low and high
   * @param low lower edge
   * @param high upper edge
   * @return this plot
   */
  public SvgPlot band(String name, String colour, double[] x, double[] low, double[] high) {
    double[] around = new double[2 * x.length];
    double[] edge = new double[2 * x.length];
    for (int i = 0; i < x.length; i++) {
      around[i] = x[i];
      edge[i] = high[i];
      around[2 * x.length - 1 - i] = x[i];
      edge[2 * x.length - 1 - i] = low[i];
    }
    marks
        .append("<polygon stroke=\"none\" fill-opacity=\"0.25\" fill=\"")
        .append(colour)
        .append("\" points=\"");
    marks.append(points(around, edge)).append("\"/>\n");
    return named(name, colour);
  }

  /**
   * Dots; those outside the range lie on its edge.
   *
   * @param name for the legend, empty for none
   * @param colour as SVG has it
   * @param x as many as y
   * @param y values
   * @return this plot
   */
  public SvgPlot dots(String name, String colour, double[] x, double[] y) {
    marks.append("<g fill=\"").append(colour).append("\">\n");
    for (int i = 0; i < x.length; i++) {
      if (Double.isNaN(x[i] + y[i])) {
        continue;
      }
      marks.append(text("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"1.5\"/>%n", atX(x[i]), atY(y[i])));
    }
    marks.append("</g>\n");
    return named(name, colour);
  }

  /**
   * A horizontal line over the whole width.
   *
   * @param name for the legend, empty for none
   * @param colour as SVG has it
   * @param y value
   * @return this plot
   */
  public SvgPlot level(String name, String colour, double y) {
    return line(name, colour, new double[] {fromX, toX}, new double[] {y, y});
  }

  /**
   * Writes the plot; an existing file is replaced.
   *
   * @param file its folder is created if necessary
   * @param title above the plot
   * @param xLabel quantity and unit
   * @param yLabel quantity and unit
   * @throws IOException if it cannot be written
   */
  public void write(Path file, String title, String xLabel, String yLabel) throws IOException {
    Files.createDirectories(file.getParent());
    Files.writeString(file, draw(title, xLabel, yLabel));
  }

  /**
   * Draws the plot.
   *
   * @param title above the plot
   * @param xLabel quantity and unit
   * @param yLabel quantity and unit
   * @return an SVG document
   */
  public String draw(String title, String xLabel, String yLabel) {
    StringBuilder svg = new StringBuilder();
    int top = names.isEmpty() ? 0 : -LEGEND;
    svg.append(
        text(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 %d %d %d\""
                + " font-family=\"sans-serif\" font-size=\"11\">%n",
            top, WIDTH, HEIGHT - top));
    svg.append(
        text(
            "<rect y=\"%d\" width=\"%d\" height=\"%d\" fill=\"white\"/>%n",
            top, WIDTH, HEIGHT - top));
    svg.append(label(WIDTH / 2.0, top + 16, "middle", title));
    svg.append(legend());
    grid(svg);
    svg.append(marks);
    String after =
        originX() == 0
            ? ""
            : " after " + new BigDecimal(originX(), MathContext.DECIMAL64).toPlainString();
    svg.append(label((left + WIDTH - RIGHT) / 2.0, HEIGHT - 8, "middle", xLabel + after));
    svg.append(
        text(
            "<g transform=\"translate(14 %d) rotate(-90)\">%n%s</g>%n",
            (TOP + HEIGHT - BOTTOM) / 2, label(0, 0, "middle", yLabel)));
    return svg.append("</svg>\n").toString().replace(System.lineSeparator(), "\n");
  }

  /** The names in a row of their own above the plot, where they cover no line. */
  private String legend() {
    if (names.isEmpty()) {
      return "";
    }
    StringBuilder row = new StringBuilder();
    for (int i = 0; i < names.size(); i++) {
      row.append(text("<tspan dx=\"%d\" fill=\"%s\">", i == 0 ? 0 : NAME_GAP, colours.get(i)));
      row.append(escaped(names.get(i))).append("</tspan>");
    }
    return text(
        "<text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">%s</text>%n",
        (left + WIDTH - RIGHT) / 2.0, TOP - 10, row);
  }

  private SvgPlot named(String name, String colour) {
    if (!name.isEmpty()) {
      names.add(name);
      colours.add(colour);
    }
    return this;
  }

  private void grid(StringBuilder svg) {
    svg.append("<g stroke=\"#ddd\">\n");
    StringBuilder labels = new StringBuilder();
    Ticks across = Ticks.of(fromX, toX, MAX_TICKS);
    for (double x : across.values()) {
      if (wholeX && x != Math.rint(x)) {
        continue;
      }
      svg.append(segment(atX(x), TOP, atX(x), HEIGHT - BOTTOM));
      String words = wholeX ? Long.toString((long) x) : number(across, x - originX());
      labels.append(label(atX(x), HEIGHT - BOTTOM + 15, "middle", words));
    }
    Ticks up = Ticks.of(fromY, toY, MAX_TICKS);
    for (double y : up.values()) {
      svg.append(segment(left, atY(y), WIDTH - RIGHT, atY(y)));
      labels.append(label(left - 6, atY(y) + 4, "end", number(up, y)));
    }
    svg.append("</g>\n").append(labels);
  }

  /** Origin of the numbers below the plot: a round number if they are too long from 0. */
  private double originX() {
    if (Ticks.of(fromX, toX, MAX_TICKS).label(toX).length() <= MAX_DIGITS) {
      return 0;
    }
    double round = Math.pow(10, Math.ceil(Math.log10(toX - fromX)));
    return Math.floor(fromX / round) * round;
  }

  private String points(double[] x, double[] y) {
    StringBuilder points = new StringBuilder();
    for (int i = 0; i < x.length; i++) {
      if (!Double.isNaN(x[i] + y[i])) {
        points.append(text("%.1f,%.1f ", atX(x[i]), atY(y[i])));
      }
    }
    return points.toString().trim();
  }

  private double atX(double x) {
    return left
        + (WIDTH - left - RIGHT) * (Math.min(toX, Math.max(fromX, x)) - fromX) / (toX - fromX);
  }

  private double atY(double y) {
    double share = (Math.min(toY, Math.max(fromY, y)) - fromY) / (toY - fromY);
    return HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * share;
  }

  private static String number(Ticks ticks, double value) {
    return ticks.label(value).replace('-', '−');
  }

  private static String segment(double x1, double y1, double x2, double y2) {
    return text("<path d=\"M%.1f %.1fL%.1f %.1f\"/>%n", x1, y1, x2, y2);
  }

  private static String label(double x, double y, String anchor, String words) {
    return text(
        "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">%s</text>%n", x, y, anchor, escaped(words));
  }

  /**
   * Escapes a text for SVG and HTML, also in attributes.
   *
   * @param words any text
   * @return the text with special characters escaped
   */
  public static String escaped(String words) {
    return words
        .replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }

  private static String text(String format, Object... values) {
    return String.format(Locale.ROOT, format, values);
  }
}
