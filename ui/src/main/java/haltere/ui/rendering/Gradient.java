package haltere.ui.rendering;

import java.util.List;

/**
 * Colours of a quantity from none to much. Lightness is monotonic, so the gradient is readable with
 * colour blindness and in monochrome print.
 *
 * @param name display name
 * @param anchors opaque ARGB at even distances, at least two
 */
public record Gradient(String name, List<Integer> anchors) {
  /** From dark blue over grey to yellow, made for colour-blind eyes (Nuñez and others 2018). */
  public static final Gradient CIVIDIS =
      new Gradient(
          "Cividis",
          List.of(0xFF00204D, 0xFF31446B, 0xFF666970, 0xFF958F78, 0xFFCBBA69, 0xFFFFEA46));

  /** From violet over green to yellow, as matplotlib's default. */
  public static final Gradient VIRIDIS =
      new Gradient(
          "Viridis",
          List.of(0xFF440154, 0xFF414487, 0xFF2A788E, 0xFF22A884, 0xFF7AD151, 0xFFFDE725));

  /** From black over red to light yellow. */
  public static final Gradient INFERNO =
      new Gradient(
          "Inferno",
          List.of(0xFF000004, 0xFF420A68, 0xFF932667, 0xFFDD513A, 0xFFFCA50A, 0xFFFCFFA4));

  /** From black to white. */
  public static final Gradient GREY = new Gradient("Grey", List.of(0xFF000000, 0xFFFFFFFF));

  /** From white to black, for print. */
  public static final Gradient INK = new Gradient("Ink on paper", List.of(0xFFFFFFFF, 0xFF000000));

  /** Copies the anchors and checks that there are two. */
  public Gradient {
    anchors = List.copyOf(anchors);
    if (anchors.size() < 2) {
      throw new IllegalArgumentException("a gradient needs two colours, not " + anchors.size());
    }
  }

  /** All gradients, in the order of a menu. */
  public static List<Gradient> all() {
    return List.of(CIVIDIS, VIRIDIS, INFERNO, GREY, INK);
  }

  /** The opaque ARGB of a share of 0 to 1; beyond that of the ends. */
  public int colour(double share) {
    double position = Math.max(0, Math.min(1, share)) * (anchors.size() - 1);
    int below = Math.min(anchors.size() - 2, (int) position);
    return ColourMap.mix(anchors.get(below), anchors.get(below + 1), position - below);
  }
}
