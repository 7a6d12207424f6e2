package haltere.ui.viewer.plots;

import haltere.ui.plot.Curve;
import haltere.ui.plot.Lane;
import haltere.ui.plot.Ticks;
import haltere.ui.plot.TimeWindow;
import java.util.List;
import javafx.geometry.VPos;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.text.Font;
import javafx.scene.text.TextAlignment;

/**
 * Draws a lane: axes, grid and curves. Samples that share a column of pixels become one upright
 * line, so what it costs does not depend on how many there are.
 *
 * <p>Thread rule: JavaFX thread only.
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

  private final Lane lane;
  private final TimeWindow window;
  private final Columns columns = new Columns();
  private double lowest;
  private double highest;

  LanePicture(Lane lane, TimeWindow window) {
    this.lane = lane;
    this.window = window;
  }

  /** Place in the window, 0 to 1 within it, of a horizontal coordinate. */
  static double place(double x, double width) {
    return (x - LEFT) / Math.max(1, width - LEFT - RIGHT);
  }

  /** Horizontal coordinate of a place in the window. */
  static double x(double place, double width) {
    return LEFT + place * (width - LEFT - RIGHT);
  }

  /**
   * Draws the lane anew.
   *
   * @param startUs the recording's clock at its start
   */
  void draw(GraphicsContext graphics, double width, double height, PlotInk ink, long startUs) {
    graphics.clearRect(0, 0, width, height);
    int wide = (int) Math.max(1, width - LEFT - RIGHT);
    List<Curve> curves = lane.curves();
    range(curves, wide);
    grid(graphics, width, height, ink, startUs);
    graphics.setLineWidth(1.2);
    graphics.save();
    graphics.beginPath();
    graphics.rect(LEFT, 0, wide, height);
    graphics.clip();
    for (Curve curve : curves) {
      graphics.setStroke(ink.curve(curve.number()));
      columns.begin(graphics, width, height);
      curve.paint(window.fromUs(), window.toUs(), wide, columns);
      columns.end();
    }
    graphics.restore();
  }

  private void range(List<Curve> curves, int wide) {
    lowest = Double.POSITIVE_INFINITY;
    highest = Double.NEGATIVE_INFINITY;
    for (Curve curve : curves) {
      curve.paint(
          window.fromUs(),
          window.toUs(),
          wide,
          (fromUs, toUs, low, high, joined) -> {
            if (toUs >= window.fromUs() && fromUs <= window.toUs()) {
              lowest = Math.min(lowest, low);
              highest = Math.max(highest, high);
            }
          });
    }
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
      GraphicsContext graphics, double width, double height, PlotInk ink, long startUs) {
    graphics.setFont(FONT);
    graphics.setFill(ink.text());
    graphics.setStroke(ink.grid());
    graphics.setLineWidth(1);
    graphics.setTextAlign(TextAlignment.RIGHT);
    graphics.setTextBaseline(VPos.CENTER);
    Ticks values = Ticks.atLeastTwo(lowest, highest, (int) (height / TICK_DISTANCE));
    double labelled = Double.POSITIVE_INFINITY;
    for (double value : values.values()) {
      double y = Math.rint(y(value, height)) + 0.5;
      graphics.strokeLine(LEFT, y, width - RIGHT, y);
      // whole, and clear of the one below
      double middle = Math.max(LINE / 2, Math.min(height - LINE / 2, y));
      if (middle <= labelled - LINE) {
        graphics.fillText(values.label(value), LEFT - 6, middle);
        labelled = middle;
      }
    }
    for (double seconds : PlotTimeAxis.ticks(window, startUs, width).values()) {
      double place = window.placeOf(startUs + Math.round(seconds * 1e6));
      double x = Math.rint(x(place, width)) + 0.5;
      graphics.strokeLine(x, 0, x, height);
    }
  }

  /** Puts together what falls on the same column of pixels, and strokes it. */
  private final class Columns implements Curve.Painter {
    private GraphicsContext graphics;
    private double width;
    private double height;
    private boolean any;
    private boolean lineOpen;
    private double x;
    private double low;
    private double high;
    private double lastValue;

    void begin(GraphicsContext target, double wide, double tall) {
      graphics = target;
      width = wide;
      height = tall;
      any = false;
      lineOpen = false;
      graphics.beginPath();
    }

    @Override
    public void stretch(long fromUs, long toUs, double lowestOf, double highestOf, boolean joined) {
      double middle = (lowestOf + highestOf) / 2;
      double at = Math.rint(LanePicture.x(window.placeOf(fromUs + (toUs - fromUs) / 2), width));
      if (any && joined && at == x) {
        low = Math.min(low, lowestOf);
        high = Math.max(high, highestOf);
      } else {
        flush();
        if (any && joined) {
          graphics.lineTo(at, y(middle, height));
        } else {
          graphics.moveTo(at, y(middle, height));
        }
        any = true;
        lineOpen = true;
        x = at;
        low = lowestOf;
        high = highestOf;
      }
      lastValue = middle;
    }

    private void flush() {
      if (lineOpen && high > low) {
        graphics.lineTo(x, y(low, height));
        graphics.lineTo(x, y(high, height));
        graphics.lineTo(x, y(lastValue, height));
      } else if (lineOpen) {
        // a sample by itself is a dot
        graphics.lineTo(x + 0.01, y(lastValue, height));
      }
      lineOpen = false;
    }

    void end() {
      flush();
      graphics.stroke();
    }
  }
}
