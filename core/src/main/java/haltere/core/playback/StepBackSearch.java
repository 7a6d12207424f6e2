package haltere.core.playback;

import java.io.IOException;

/**
 * Finds the position a number of events before another one, in growing windows, because sources
 * play forward only. It leaves its cursor at an arbitrary position.
 */
final class StepBackSearch {
  private static final long MIN_WINDOW_US = 1000;

  /**
   * A position among events.
   *
   * @param elapsedUs elapsed time
   * @param ties events with this elapsed time before the position
   */
  record Position(long elapsedUs, int ties) {}

  private final SourceCursor cursor;
  private final double eventRateEps;
  private long passed;

  StepBackSearch(SourceCursor cursor, double eventRateEps) {
    this.cursor = cursor;
    this.eventRateEps = Math.max(1, eventRateEps);
  }

  Position before(Position boundary, long events) throws IOException {
    long end = boundary.elapsedUs();
    long window = Math.max(MIN_WINDOW_US, (long) (2 * events / eventRateEps * 1e6));
    long earliest = cursor.earliestUs();
    while (end > earliest) {
      long from = Math.max(earliest, end - window);
      pass(from, end, Long.MAX_VALUE);
      long found = passed + boundary.ties();
      if (found >= events) {
        return pass(from, end + 1, found - events);
      }
      if (from == earliest) {
        break;
      }
      window = window > end / 4 ? end : window * 4;
    }
    return new Position(earliest, 0);
  }

  /**
   * Skips events between two positions, or a number of them; returns the position of the next one.
   */
  private Position pass(long from, long to, long max) throws IOException {
    cursor.seek(from);
    passed = 0;
    long last = Long.MIN_VALUE;
    int ties = 0;
    while (true) {
      switch (cursor.ahead()) {
        case NOTIFICATION -> cursor.takeNotification();
        case SAMPLE -> cursor.takeSample();
        case END -> {
          return new Position(last, ties);
        }
        case EVENTS -> {
          long elapsedUs = cursor.elapsedUs();
          if (elapsedUs >= to || passed == max) {
            return new Position(elapsedUs, elapsedUs == last ? ties : 0);
          }
          ties = elapsedUs == last ? ties + 1 : 1;
          last = elapsedUs;
          passed++;
          cursor.skip(1);
        }
        case UNKNOWN -> {}
      }
    }
  }
}
