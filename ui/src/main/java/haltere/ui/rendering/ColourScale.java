package haltere.ui.rendering;

import java.util.Optional;

/**
 * What the ends of a gradient stand for, where colours stand for ages or counts.
 *
 * <p>Thread rule: immutable.
 *
 * @param gradient the colours
 * @param first what the first colour stands for, in words
 * @param last what the last colour stands for, in words
 */
public record ColourScale(Gradient gradient, String first, String last) {
  /**
   * The scale of a mode whose colours stand for ages or counts, by the highest of them in words;
   * empty for other modes, and where that is not known.
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
