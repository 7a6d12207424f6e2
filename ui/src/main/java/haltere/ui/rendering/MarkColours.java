package haltere.ui.rendering;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * Colours and widths of marks by their meaning. Marks with an identity get colours that differ from
 * those of the events and of neighbours, safe for colour blindness.
 */
public final class MarkColours {
  private static final int[] ON_DARK = {
    0xFFF0E442, 0xFF2ED3A5, 0xFFF08CCB, 0xFFB9A7FF, 0xFFBDF26D, 0xFF8BE9FD, 0xFFFFFFFF, 0xFFFFC9B0,
  };
  private static final int[] ON_LIGHT = {
    0xFF7A6A00, 0xFF00785A, 0xFF9C2F77, 0xFF5B3FD0, 0xFF3F6B00, 0xFF006C85, 0xFF24292F, 0xFF8A3B12,
  };

  private static final Pattern IDENTITY = Pattern.compile("\\d{1,9}");

  private MarkColours() {}

  /** Colour of a mark on a dark or a light picture: ARGB, not always opaque. */
  public static int argb(MarkStyle style, boolean dark) {
    int[] palette = dark ? ON_DARK : ON_LIGHT;
    int own =
        style.identity() >= 0
            ? palette[Math.floorMod(style.identity(), palette.length)]
            : dark ? 0xFFF0F3F6 : 0xFF24292F;
    return switch (style.role()) {
      case OBJECT, VELOCITY, ESTIMATE, LABEL -> own;
      case PATH -> withAlpha(own, 0xA0);
      case MEASUREMENT -> withAlpha(own, 0xC0);
      case UNCERTAINTY -> withAlpha(own, 0x80);
      case SCALE -> withAlpha(own, 0x60);
      case REGION -> dark ? 0xFF8BE9FD : 0xFF006C85;
      case LEFT -> dark ? 0xFFF08CCB : 0xFF9C2F77;
      case RIGHT -> dark ? 0xFF2ED3A5 : 0xFF00785A;
      case WARNING -> dark ? 0xFFFF6B6B : 0xFFCF222E;
    };
  }

  /** Style of the marks that a curve belongs to by its key: a side of wings, or an identity. */
  public static Optional<MarkStyle> ofCurve(String key) {
    if (IDENTITY.matcher(key).matches()) {
      return Optional.of(MarkStyle.of(Role.OBJECT, Integer.parseInt(key)));
    }
    Role side = key.startsWith("left") ? Role.LEFT : key.startsWith("right") ? Role.RIGHT : null;
    return Optional.ofNullable(side).map(MarkStyle::of);
  }

  /** Width of a mark's line, pixels of the screen. */
  public static double width(MarkStyle style) {
    return switch (style.role()) {
      case OBJECT, ESTIMATE, LEFT, RIGHT, WARNING -> 2;
      case VELOCITY -> 2.5;
      case PATH, MEASUREMENT, UNCERTAINTY, REGION, LABEL -> 1.5;
      case SCALE -> 1;
    };
  }

  /** Colour behind text, for readability over events: ARGB, not opaque. */
  public static int plate(boolean dark) {
    return dark ? 0xB80D1117 : 0xC8FFFFFF;
  }

  private static int withAlpha(int argb, int alpha) {
    return argb & 0xFFFFFF | alpha << 24;
  }
}
