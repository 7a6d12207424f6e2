package haltere.ui.viewer.plots;

import haltere.core.sink.internal.Ticks;
import haltere.ui.plot.TimeWindow;
import javafx.geometry.VPos;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.layout.Region;
import javafx.scene.text.Font;
import javafx.scene.text.TextAlignment;

/** The common time axis of all lanes, in seconds since the start of the recording. */
final class PlotTimeAxis extends Region {
  private static final double HEIGHT = 18;
  private static final Font FONT = Font.font(10.5);

  private final TimeWindow window;
  private final Canvas canvas = new Canvas();

  PlotTimeAxis(TimeWindow window) {
    this.window = window;
    setMinHeight(HEIGHT);
    setPrefHeight(HEIGHT);
    setMaxHeight(HEIGHT);
    canvas.setManaged(false);
    getChildren().add(canvas);
  }

  /** Round seconds since the start of the recording. */
  static Ticks ticks(TimeWindow window, long startUs, double width) {
    return Ticks.of(
        (window.fromUs() - startUs) / 1e6,
        (window.toUs() - startUs) / 1e6,
        (int) Math.max(2, width / 110));
  }

  /** Redraws the axis, by the recording's clock at its start. */
  void draw(PlotColours colours, long startUs) {
    double width = getWidth();
    if (canvas.getWidth() != width) {
      canvas.setWidth(width);
      canvas.setHeight(HEIGHT);
    }
    GraphicsContext graphics = canvas.getGraphicsContext2D();
    graphics.clearRect(0, 0, width, HEIGHT);
    graphics.setFont(FONT);
    graphics.setFill(colours.text());
    graphics.setTextAlign(TextAlignment.CENTER);
    graphics.setTextBaseline(VPos.CENTER);
    Ticks ticks = ticks(window, startUs, width);
    for (double seconds : ticks.values()) {
      double share = window.shareOf(startUs + Math.round(seconds * 1e6));
      graphics.fillText(ticks.label(seconds) + " s", LanePicture.x(share, width), HEIGHT / 2);
    }
  }
}
