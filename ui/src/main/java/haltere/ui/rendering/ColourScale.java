package haltere.ui.rendering;

import java.util.Optional;

/**
 * The meaning of the ends of a gradient that shows ages or counts.
 *
 * <p>Thread rule: immutable.
 *
 * @param gradient the colours
 * @param first meaning of the first colour, as text
 * @param last meaning of the last colour, as text
 */
public record ColourScale(Gradient gradient, String first, String last) {
  /**
   * The scale of a mode that shows ages or counts, by the text of its maximum; empty for other
   * modes, and for an unknown maximum.
   */
  public static Optional<ColourScale> of(DisplayMode mode, Gradient gradient, String farEnd) {
    if (farEnd.isEmpty()) {
      return Optional.empty();
    }
    return switch (mode) {
      case TIME_SURFACE -> Optional.of(new ColourScale(gradient, farEnd, "now"));
      case COUNTS -> Optional.of(new ColourScale(gradient, "0", farEnd));
      case FREQUENCY -> Optional.of(new ColourScale(gradient, "5 Hz", farEnd));
      default -> Optional.empty();
    };
  }
}
