package haltere.ui.rendering;

/**
 * Colours of a picture of events: background, fresh ON and fresh OFF events. All but green and red
 * are safe for the common kinds of colour blindness.
 *
 * @param name display name
 * @param background opaque ARGB of a pixel without a recent event
 * @param on opaque ARGB of a fresh ON event
 * @param off opaque ARGB of a fresh OFF event
 * @param dark whether marks drawn over the picture should be light
 */
public record ColourMap(String name, int background, int on, int off, boolean dark) {
  /** Orange and blue on near black: the default. */
  public static final ColourMap DARK =
      new ColourMap("Dark", 0xFF0B0E14, 0xFFFFA630, 0xFF3E8EFF, true);

  /** Orange-brown and blue on near white, for print and bright rooms. */
  public static final ColourMap LIGHT =
      new ColourMap("Light", 0xFFFAFBFC, 0xFFC2500A, 0xFF1B4FD1, false);

  /** White and black on grey. */
  public static final ColourMap GREY =
      new ColourMap("Grey", 0xFF6B7078, 0xFFFFFFFF, 0xFF000000, true);

  /** Vermilion and blue on white, of the palette of Okabe and Ito. */
  public static final ColourMap PAPER =
      new ColourMap("Red and blue on white", 0xFFFFFFFF, 0xFFD55E00, 0xFF0072B2, false);

  /** Yellow and sky blue on black, of the palette of Okabe and Ito: the strongest contrast. */
  public static final ColourMap CONTRAST =
      new ColourMap("Yellow and blue on black", 0xFF000000, 0xFFF0E442, 0xFF56B4E9, true);

  /** Green and red on black, as older viewers have it; not for everyone's eyes. */
  public static final ColourMap GREEN_RED =
      new ColourMap("Green and red", 0xFF000000, 0xFF2BE04A, 0xFFFF3B3B, true);

  /** All maps, in the order of a menu. */
  public static java.util.List<ColourMap> all() {
    return java.util.List.of(DARK, LIGHT, CONTRAST, PAPER, GREY, GREEN_RED);
  }

  /** The opaque ARGB between the background (freshness 0) and that of a fresh event (1). */
  public int colour(boolean on, double freshness) {
    return mix(background, on ? this.on : off, Math.max(0, Math.min(1, freshness)));
  }

  /** The opaque ARGB between two colours, at a share of 0 to 1. */
  static int mix(int from, int to, double share) {
    int result = 0xFF;
    for (int shift = 16; shift >= 0; shift -= 8) {
      int a = from >>> shift & 0xFF;
      int b = to >>> shift & 0xFF;
      result = result << 8 | (int) Math.round(a + (b - a) * share);
    }
    return result;
  }
}
