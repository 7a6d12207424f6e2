package haltere.core.playback;

/**
 * How a stream is cut into consecutive slices. A slice does not depend on the packets of the
 * source. A notification that ends the continuity of the stream also ends a slice.
 *
 * @since 0.1
 */
public sealed interface Slicing {
  /**
   * Slices of the same time, {@code [start, start + sliceUs)}; those without events count too.
   *
   * @param sliceUs length in microseconds of recording time, at least 1
   */
  record ByTime(long sliceUs) implements Slicing {
    /** Checks the length. */
    public ByTime {
      if (sliceUs < 1) {
        throw new IllegalArgumentException("a slice lasts at least 1 us, not " + sliceUs);
      }
    }
  }

  /**
   * Slices of the same number of events, from the time of the first to just after the time of the
   * last. Events of equal time may fall into two slices.
   *
   * @param events number of events before the chain, at least 1
   */
  record ByCount(int events) implements Slicing {
    /** Checks the number. */
    public ByCount {
      if (events < 1) {
        throw new IllegalArgumentException("a slice has at least 1 event, not " + events);
      }
    }
  }

  /**
   * Slices of the recording time of one picture: speed divided by frame rate, at least 1 us. At
   * unlimited speed the slices are those of speed 1.
   *
   * @param framesPerSecond frame rate in real time, Hz, above 0
   */
  record PerFrame(double framesPerSecond) implements Slicing {
    /** Checks the rate. */
    public PerFrame {
      if (!(framesPerSecond > 0) || Double.isInfinite(framesPerSecond)) {
        throw new IllegalArgumentException(
            "pictures per second must be above 0, not " + framesPerSecond);
      }
    }
  }
}
