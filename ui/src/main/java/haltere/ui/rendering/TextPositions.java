package haltere.ui.rendering;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Places text in a picture without clipping or overlaps. Earlier text has its preferred position,
 * later text goes beside it. Without room within two lines, the label of one of several objects is
 * omitted and other text is drawn at its preferred position.
 *
 * <p>Lengths are pixels, rows count from the top.
 */
public final class TextPositions {
  /** Offsets from the preferred position: widths to the left, then lines up. */
  private static final int[][] BESIDE = {
    {0, 0}, {0, 1}, {0, -1}, {1, 0}, {1, 1}, {1, -1}, {0, 2}, {0, -2}, {1, 2}, {1, -2}
  };

  private final List<Rectangle2D> taken = new ArrayList<>();
  private double pictureWidth;
  private double pictureHeight;

  /** Starts a picture without text. */
  public void begin(double width, double height) {
    pictureWidth = width;
    pictureHeight = height;
    taken.clear();
  }

  /**
   * Finds and occupies the plate of text with a preferred start and base line, extents above and
   * below it and a margin at either side; empty for text that is omitted.
   */
  public Optional<Rectangle2D> find(
      double preferredLeft,
      double preferredBase,
      double width,
      double ascent,
      double descent,
      double margin,
      MarkStyle style) {
    double line = ascent + descent;
    Rectangle2D preferred = null;
    for (int[] step : BESIDE) {
      // about the same distance to the left of a mark as to its right
      double left = preferredLeft - step[0] * (width + 4 * margin);
      left = Math.max(margin, Math.min(left, pictureWidth - width - margin));
      double base = preferredBase - step[1] * line;
      base = Math.max(ascent, Math.min(base, pictureHeight - descent));
      Rectangle2D plate =
          new Rectangle2D.Double(left - margin, base - ascent, width + 2 * margin, line);
      if (taken.stream().noneMatch(plate::intersects)) {
        taken.add(plate);
        return Optional.of(plate);
      }
      preferred = preferred == null ? plate : preferred;
    }
    boolean isOmitted = style.role() == Role.LABEL && style.identity() >= 0;
    return isOmitted ? Optional.empty() : Optional.of(preferred);
  }
}
