package haltere.ui.rendering;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/**
 * Where the words of a picture go so that they stay whole at its edges and none lie over others.
 * What comes first has the place that it wants. What comes later goes beside it, and if there is no
 * room within two lines, the label of one of several objects is left out and other words are drawn
 * where they want to be.
 *
 * <p>Lengths are pixels, rows count from the top.
 */
public final class TextPositions {
  /** Beside the wanted place: widths to the left, then lines up. */
  private static final int[][] BESIDE = {
    {0, 0}, {0, 1}, {0, -1}, {1, 0}, {1, 1}, {1, -1}, {0, 2}, {0, -2}, {1, 2}, {1, -2}
  };

  private final List<Rectangle2D> taken = new ArrayList<>();
  private double pictureWidth;
  private double pictureHeight;
  private double left;
  private double base;

  /** Begins a picture without words. */
  public void begin(double width, double height) {
    pictureWidth = width;
    pictureHeight = height;
    taken.clear();
  }

  /**
   * Finds room for words that should begin at a place on a base line, with their room above and
   * below it and a margin at either side, and takes it. Returns whether they are to be drawn, at
   * {@link #left()} and {@link #base()}.
   */
  public boolean find(
      double wantedLeft,
      double wantedBase,
      double width,
      double ascent,
      double descent,
      double margin,
      MarkStyle style) {
    double line = ascent + descent;
    for (int[] step : BESIDE) {
      // to the left of a mark it stands about as far away as to its right
      left = wantedLeft - step[0] * (width + 4 * margin);
      left = Math.max(margin, Math.min(left, pictureWidth - width - margin));
      base = wantedBase - step[1] * line;
      base = Math.max(ascent, Math.min(base, pictureHeight - descent));
      Rectangle2D plate =
          new Rectangle2D.Double(left - margin, base - ascent, width + 2 * margin, line);
      if (taken.stream().noneMatch(plate::intersects)) {
        taken.add(plate);
        return true;
      }
    }
    left = Math.max(margin, Math.min(wantedLeft, pictureWidth - width - margin));
    base = Math.max(ascent, Math.min(wantedBase, pictureHeight - descent));
    return style.role() != Role.LABEL || style.identity() < 0;
  }

  /** Where the words that were found room for begin. */
  public double left() {
    return left;
  }

  /** Base line of the words that were found room for. */
  public double base() {
    return base;
  }
}
