package haltere.ui.viewer.plots;

import java.util.List;
import javafx.scene.paint.Color;

/**
 * Colours of plots, which a canvas cannot take from the style sheet. Those of curves can be told
 * apart by colour-blind people (Okabe and Ito, 2008, with the yellow left out on white).
 *
 * @param text words and numbers
 * @param grid lines at round numbers
 * @param now the place of playback
 * @param cursor the mouse
 * @param curves used in turn
 */
record PlotInk(Color text, Color grid, Color now, Color cursor, List<Color> curves) {
  static final PlotInk DARK =
      new PlotInk(
          Color.web("#9da7b3"),
          Color.web("#30363d"),
          Color.web("#e6edf3", 0.5),
          Color.web("#e6edf3"),
          curves("#56b4e9", "#e69f00", "#2ed3a5", "#f0e442", "#ff7b4a", "#d58fbf", "#4f8fe6"));

  static final PlotInk LIGHT =
      new PlotInk(
          Color.web("#57606a"),
          Color.web("#d8dee4"),
          Color.web("#1f2328", 0.4),
          Color.web("#1f2328"),
          curves("#0072b2", "#b36b00", "#00785a", "#d55e00", "#a8487f", "#2f8fc4", "#57606a"));

  private static List<Color> curves(String... colours) {
    return List.of(colours).stream().map(Color::web).toList();
  }

  Color curve(int number) {
    return curves.get(Math.floorMod(number, curves.size()));
  }
}
