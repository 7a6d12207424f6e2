package haltere.ui.command.terminal;

import haltere.core.event.EventPacket;
import haltere.core.stream.DataLost;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;

/**
 * Event rate over time as one line of block characters. The bins double in length whenever the
 * stream outgrows the line, so its length need not be known.
 *
 * <p>Thread rule: one thread.
 */
public final class RateLine implements StreamHandler {
  private static final int BINS = 48;
  private static final String BLOCKS = "\u2581\u2582\u2583\u2584\u2585\u2586\u2587\u2588";

  private final long[] events = new long[BINS];
  private long binUs = 1_000;
  private long baseUs = StreamNotification.NO_TIME_US;
  private long elapsedUs;

  @Override
  public void packet(EventPacket packet) {
    for (int i = 0; i < packet.size(); i++) {
      long timeUs = packet.timeUs(i);
      if (baseUs == StreamNotification.NO_TIME_US) {
        baseUs = timeUs - elapsedUs;
      }
      elapsedUs = timeUs - baseUs;
      while (elapsedUs / binUs >= BINS) {
        for (int bin = 0; bin < BINS; bin++) {
          events[bin] = 2 * bin < BINS ? events[2 * bin] + events[2 * bin + 1] : 0;
        }
        binUs *= 2;
      }
      events[(int) (elapsedUs / binUs)]++;
    }
  }

  @Override
  public void notified(StreamNotification notification) {
    if (notification.endsContinuity() && !(notification instanceof DataLost)) {
      baseUs = StreamNotification.NO_TIME_US;
    }
  }

  /**
   * The line.
   *
   * @return a block for each stretch of time, a space where nothing happened, and the highest rate
   */
  public String line() {
    int bins = (int) (elapsedUs / binUs) + 1;
    double[] rates = new double[bins];
    double highest = 0;
    for (int bin = 0; bin < bins; bin++) {
      // the last bin is partly filled; a short rest of it would look like a burst
      long spanUs = Math.min(binUs, Math.max(binUs / 2, elapsedUs + 1 - bin * binUs));
      rates[bin] = events[bin] * 1e6 / spanUs;
      highest = Math.max(highest, rates[bin]);
    }
    StringBuilder line = new StringBuilder();
    for (double rate : rates) {
      int height = (int) Math.ceil(BLOCKS.length() * rate / highest);
      line.append(rate == 0 ? ' ' : BLOCKS.charAt(height - 1));
    }
    return line + "  up to " + Quantities.rate(highest);
  }
}
