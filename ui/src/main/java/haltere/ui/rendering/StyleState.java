package haltere.ui.rendering;

import haltere.core.event.EventPacket;

/** The state of a style beyond the last event of each pixel. */
interface StyleState {
  /** Changes the style of the next picture. */
  void configure(PictureStyle style);

  void packet(EventPacket packet);

  /** Removes all events. */
  void clear();

  /** Removes events of the previous exposure. */
  default void beginExposure() {
    // most styles accumulate across exposures
  }

  /** The next picture is of its events alone. */
  default void settle() {
    // most styles do not smooth
  }

  /** Frequency of a pixel in hertz, NaN if unknown. */
  default double frequencyHz(int x, int y, long nowUs) {
    return Double.NaN;
  }

  /** Number of events with the colour of the maximum, 0 for styles without counts. */
  default double fullCount() {
    return 0;
  }

  /** Whether the last picture was the background alone, for an explanation to the user. */
  default boolean isEmpty() {
    return false;
  }

  /** Paints row by row from the top, with ranks in place of opacity. */
  void paint(long nowUs, int[] ranked);
}
