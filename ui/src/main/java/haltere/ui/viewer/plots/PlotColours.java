package haltere.ui.viewer.plots;

import haltere.core.overlay.MarkStyle;
import haltere.ui.plot.Curve;
import haltere.ui.rendering.MarkColours;
import haltere.ui.viewer.controls.Theme;
import java.util.List;
import javafx.scene.paint.Color;

/**
 * Colours of plots, which a canvas cannot take from the style sheet. Those of curves are safe for
 * colour blindness (Okabe and Ito, 2008, without yellow on white).
 *
 * @param text text and numbers
 * @param grid lines at round numbers
 * @param now the position of playback
 * @param cursor the mouse
 * @param curves used in turn
 */
record PlotColours(Color text, Color grid, Color now, Color cursor, List<Color> curves) {
  private static final double SHADE = 0.25;

  static final PlotColours DARK =
      new PlotColours(
          Color.web("#9da7b3"),
          Color.web("#30363d"),
          Color.web("#e6edf3", 0.5),
          Color.web("#e6edf3"),
          curves("#56b4e9", "#e69f00", "#8be9fd", "#f0e442", "#ff7b4a", "#d58fbf", "#4f8fe6"));

  static final PlotColours LIGHT =
      new PlotColours(
          Color.web("#57606a"),
          Color.web("#d8dee4"),
          Color.web("#1f2328", 0.4),
          Color.web("#1f2328"),
          curves("#0072b2", "#b36b00", "#006c85", "#d55e00", "#a8487f", "#2f8fc4", "#57606a"));

  private static List<Color> curves(String... colours) {
    return List.of(colours).stream().map(Color::web).toList();
  }

  /**
   * The colour of a curve: that of its side or identity in the picture, darker for the second and
   * third curve of a wing or field of a lane; else its own.
   */
  Color curve(Curve curve) {
    int number = curve.number();
    return MarkColours.ofCurve(curve.key())
        .map(style -> marked(style, style.identity() < 0 ? number / 2 : curve.field()))
        .orElseGet(() -> curves.get(Math.floorMod(number, curves.size())));
  }

  private Color marked(MarkStyle style, int before) {
    Color colour = Theme.colour(MarkColours.argb(style, this == DARK));
    return colour.deriveColor(0, 1, 1 - SHADE * (before % 3), 1);
  }
}
