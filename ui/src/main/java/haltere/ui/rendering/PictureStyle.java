package haltere.ui.rendering;

import java.util.Objects;

/**
 * The style of a picture of events.
 *
 * @param mode meaning of the colour of a pixel
 * @param colours for polarities, and for the background
 * @param gradient for ages and counts
 * @param timeConstantUs age at which an event has faded to 1/e, 1 us to {@link
 *     FramePainter#MAX_TIME_CONSTANT_US}; or the length of what is shown
 * @param sharp whether events count fully for that time and not at all after it
 */
public record PictureStyle(
    DisplayMode mode, ColourMap colours, Gradient gradient, long timeConstantUs, boolean sharp) {
  /** All that a picture remembers of events, about two minutes. */
  static final long ACCUMULATED_US = 1L << 27;

  /** Checks the time. */
  public PictureStyle {
    Objects.requireNonNull(mode, "mode");
    Objects.requireNonNull(colours, "colours");
    Objects.requireNonNull(gradient, "gradient");
    if (timeConstantUs < 1
        || timeConstantUs > FramePainter.MAX_TIME_CONSTANT_US
            && !(sharp && timeConstantUs == ACCUMULATED_US)) {
      throw new IllegalArgumentException(
          "the time constant is " + timeConstantUs + " us, it must be 1 us to 20 s");
    }
  }

  /** A style of all events of the last two minutes, which do not fade. */
  public static PictureStyle accumulated(DisplayMode mode, ColourMap colours, Gradient gradient) {
    return new PictureStyle(mode, colours, gradient, ACCUMULATED_US, true);
  }

  /** Polarities that fade to 1/e within a time. */
  public static PictureStyle fading(ColourMap colours, long timeConstantUs) {
    return new PictureStyle(DisplayMode.POLARITY, colours, Gradient.CIVIDIS, timeConstantUs, false);
  }

  /** Whether the background is dark, so that marks over it should be light. */
  public boolean dark() {
    int colour = background();
    int red = colour >> 16 & 0xFF;
    int green = colour >> 8 & 0xFF;
    int blue = colour & 0xFF;
    return 0.299 * red + 0.587 * green + 0.114 * blue < 150;
  }

  /** Time after which nothing is left of an event, microseconds. */
  public double maxAgeUs() {
    return sharp ? timeConstantUs : timeConstantUs * FramePainter.TIME_CONSTANTS;
  }

  /** Intensity of an event by its age: 1 at first, 0 at the end. */
  double freshness(double ageUs) {
    if (sharp) {
      return ageUs <= timeConstantUs ? 1 : 0;
    }
    return Math.exp(-ageUs / timeConstantUs);
  }

  /** Colour of a pixel without events: red, green and blue. */
  public int background() {
    return switch (mode) {
      case POLARITY, ON_ONLY, OFF_ONLY, FREQUENCY -> colours.background();
      case TIME_SURFACE, COUNTS -> gradient.colour(0);
      case INTENSITY -> Gradient.GREY.colour(0.5);
    };
  }

  /** Colour of a pixel by the age of its last event, for styles of the last event. */
  int colour(boolean on, double ageUs) {
    if (!mode.shows(on)) {
      return background();
    }
    // a time surface shows times, so it fades linearly
    return mode == DisplayMode.TIME_SURFACE
        ? gradient.colour(1 - ageUs / maxAgeUs())
        : colours.colour(on, freshness(ageUs));
  }
}
