package haltere.ui.viewer.plots;

import haltere.core.sink.internal.Ticks;
import haltere.ui.plot.Curve;
import haltere.ui.plot.Lane;
import haltere.ui.plot.TimeWindow;
import haltere.ui.rendering.LinePainter;
import haltere.ui.viewer.controls.PixelImage;
import java.util.Arrays;
import java.util.List;
import javafx.geometry.VPos;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.image.ImageView;
import javafx.scene.paint.Color;
import javafx.scene.text.Font;
import javafx.scene.text.TextAlignment;

/**
 * Draws a lane: axes, grid and curves. Samples in one column of pixels become one vertical line, so
 * the cost does not depend on their number.
 */
final class LanePicture {
  /** Room for the numbers of the vertical axis. */
  static final double LEFT = 62;

  private static final double RIGHT = 8;
  private static final double TOP = 4;
  private static final double BOTTOM = 4;
  private static final Font FONT = Font.font(10.5);

  /** Height of a label. */
  private static final double LINE = 12;

  private static final double TICK_DISTANCE = 26;

  /** Of a curve. */
  private static final double THICKNESS = 1.4;

  private final Lane lane;
  private final TimeWindow window;

  /**
   * Pixels of the curves. JavaFX's shapes take several times as long for a curve with a hundred
   * extremes, and block the window.
   */
  private final PixelImage pixels = new PixelImage();

  private final LinePainter painter = new LinePainter();
  private double density;
  private final Columns columns = new Columns();
  private double lowest;
  private double highest;

  LanePicture(Lane lane, TimeWindow window) {
    this.lane = lane;
    this.window = window;
    pixels.setMouseTransparent(true);
  }

  /** Place in the window, 0 to 1 within it, of a horizontal coordinate. */
  static double shareAt(double x, double width) {
    return (x - LEFT) / Math.max(1, width - LEFT - RIGHT);
  }

  /** Horizontal coordinate of a share of the window. */
  static double x(double share, double width) {
    return LEFT + share * (width - LEFT - RIGHT);
  }

  /** Shows the curves, over the canvas that has axes and grid. */
  ImageView curves() {
    return pixels;
  }

  /**
   * Redraws the lane, axes and grid on a canvas; with pixels of the screen per unit of the lane,
   * and the start of the recording.
   */
  void draw(
      GraphicsContext graphics,
      double width,
      double height,
      double density,
      PlotColours colours,
      long startUs) {
    graphics.clearRect(0, 0, width, height);
    int wide = (int) Math.max(1, width - LEFT - RIGHT);
    List<Curve> curves = lane.curves();
    range(wide);
    grid(graphics, width, height, colours, startUs);
    begin(wide, height, density);
    for (Curve curve : curves) {
      columns.begin(argb(colours.curve(curve)), width, height);
      curve.paint(window.fromUs(), window.toUs(), wide, columns);
      columns.end();
    }
    pixels.repaint();
  }

  /** Makes all pixels of the curves transparent. */
  private void begin(double width, double height, double newDensity) {
    density = newDensity;
    int columns = Math.max(1, (int) Math.ceil(width * density));
    int rows = Math.max(1, (int) Math.ceil(height * density));
    pixels.fit(columns, rows, density);
    Arrays.fill(pixels.pixels(), 0);
    painter.setTarget(pixels.pixels(), columns, rows);
    pixels.setX(LEFT);
  }

  private void line(double x1, double y1, double x2, double y2, int argb) {
    painter.line(
        (x1 - LEFT) * density,
        y1 * density,
        (x2 - LEFT) * density,
        y2 * density,
        THICKNESS * density,
        argb,
        x1 == x2 && y1 == y2);
  }

  private static int argb(Color colour) {
    return level(colour.getOpacity()) << 24
        | level(colour.getRed()) << 16
        | level(colour.getGreen()) << 8
        | level(colour.getBlue());
  }

  private static int level(double share) {
    return (int) Math.round(share * 255);
  }

  private void range(int wide) {
    double[] range = lane.range(window, wide);
    lowest = range[0];
    highest = range[1];
    if (!(lowest <= highest)) {
      lowest = 0;
      highest = 1;
    }
    double middle = (lowest + highest) / 2;
    double half = Math.max((highest - lowest) / 2, Math.max(1e-12, Math.abs(middle) * 1e-6));
    lowest = middle - half * 1.06;
    highest = middle + half * 1.06;
  }

  private double y(double value, double height) {
    return TOP + (highest - value) / (highest - lowest) * (height - TOP - BOTTOM);
  }

  private void grid(
      GraphicsContext graphics, double width, double height, PlotColours colours, long startUs) {
    graphics.setFont(FONT);
    graphics.setTextAlign(TextAlignment.RIGHT);
    graphics.setTextBaseline(VPos.CENTER);
    Ticks values = Ticks.atLeastTwo(lowest, highest, (int) (height / TICK_DISTANCE));
    double labelled = Double.POSITIVE_INFINITY;
    for (double value : values.values()) {
      double y = Math.rint(y(value, height));
      // rectangles: strokes take many times as long
      graphics.setFill(colours.grid());
      graphics.fillRect(LEFT, y, width - RIGHT - LEFT, 1);
      // not clipped, and not over the label below
      double middle = Math.max(LINE / 2, Math.min(height - LINE / 2, y));
      if (middle <= labelled - LINE) {
        graphics.setFill(colours.text());
        graphics.fillText(values.label(value), LEFT - 6, middle);
        labelled = middle;
      }
    }
    graphics.setFill(colours.grid());
    for (double seconds : PlotTimeAxis.ticks(window, startUs, width).values()) {
      double share = window.shareOf(startUs + Math.round(seconds * 1e6));
      graphics.fillRect(Math.rint(x(share, width)), 0, 1, height);
    }
  }

  /** Combines samples of one column of pixels, and draws them. */
  private final class Columns implements Curve.Painter {
    private int argb;
    private double width;
    private double height;
    private boolean any;
    private double x;
    private double low;
    private double high;
    private double lastValue;

    /** The end of the line, and whether it is a single point so far. */
    private double penX;

    private double penY;
    private boolean isDot;

    void begin(int newArgb, double wide, double tall) {
      argb = newArgb;
      width = wide;
      height = tall;
      any = false;
      isDot = false;
    }

    private void moveTo(double toX, double value) {
      endDot();
      penX = toX;
      penY = y(value, height);
      isDot = true;
    }

    private void lineTo(double toX, double value) {
      double toY = y(value, height);
      line(penX, penY, toX, toY, argb);
      penX = toX;
      penY = toY;
      isDot = false;
    }

    /** Draws a single sample as a dot. */
    private void endDot() {
      if (isDot) {
        line(penX, penY, penX, penY, argb);
      }
    }

    @Override
    public void stretch(long fromUs, long toUs, double min, double max, boolean joined) {
      double middle = (min + max) / 2;
      double at = Math.rint(LanePicture.x(window.shareOf(fromUs + (toUs - fromUs) / 2), width));
      if (any && joined && at == x) {
        low = Math.min(low, min);
        high = Math.max(high, max);
      } else {
        flush();
        if (any && joined) {
          lineTo(at, middle);
        } else {
          moveTo(at, middle);
        }
        any = true;
        x = at;
        low = min;
        high = max;
      }
      lastValue = middle;
    }

    private void flush() {
      if (any && high > low) {
        lineTo(x, low);
        lineTo(x, high);
        lineTo(x, lastValue);
      }
    }

    void end() {
      flush();
      endDot();
    }
  }
}
