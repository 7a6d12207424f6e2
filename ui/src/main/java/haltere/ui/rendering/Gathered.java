package haltere.ui.rendering;

import haltere.core.event.EventPacket;

/** What a style needs of events beyond the last one of each pixel. */
interface Gathered {
  /** Changes what the next picture looks like. */
  void configure(PictureStyle style);

  void packet(EventPacket packet);

  /** Forgets all events. */
  void clear();

  /** Forgets what a picture of single exposures does not show. */
  default void beginExposure() {
    // most remember across exposures
  }

  /** The next picture is of its events alone. */
  default void settle() {
    // most do not smooth
  }

  /** Frequency of a pixel in hertz, NaN where none is known. */
  default double frequencyHz(int x, int y, long nowUs) {
    return Double.NaN;
  }

  /** Events of a pixel that are painted in the colour of the most, 0 where that is not counted. */
  default double fullCount() {
    return 0;
  }

  /** Whether the last picture was the background alone, where a person asks why. */
  default boolean isEmpty() {
    return false;
  }

  /** Paints row by row from the top, with ranks in place of opacity. */
  void paint(long nowUs, int[] ranked);
}
