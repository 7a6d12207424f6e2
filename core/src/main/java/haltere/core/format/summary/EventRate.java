package haltere.core.format.summary;

import haltere.core.event.EventPacket;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.util.stream.IntStream;

/**
 * Event rate over time, for one line of block characters or a plot, for streams of any length.
 *
 * <p>Thread rule: one thread.
 *
 * @since 0.1
 */
public final class EventRate implements StreamHandler {
  private static final String BLOCKS = "\u2581\u2582\u2583\u2584\u2585\u2586\u2587\u2588";

  private final TimeBins bins;
  private long baseUs = StreamNotification.NO_TIME_US;
  private long elapsedUs;
  private long firstUs = StreamNotification.NO_TIME_US;
  private long lastUs;

  /**
   * A rate without events.
   *
   * @param bins maximum number of time bins, even
   */
  public EventRate(int bins) {
    this.bins = new TimeBins(bins, 1_000);
  }

  /**
   * Time since the first event, without the gaps at clock restarts.
   *
   * @return microseconds
   */
  public long elapsedUs() {
    return elapsedUs;
  }

  /**
   * Time of the first event.
   *
   * @return microseconds on the stream's clock
   */
  public long firstUs() {
    return firstUs;
  }

  /**
   * Time of the last event.
   *
   * @return microseconds on the stream's clock
   */
  public long lastUs() {
    return lastUs;
  }

  /**
   * Events in time bins since the first event, which grow with the stream; a clock that restarts
   * continues.
   *
   * @return the live bins, not a copy
   */
  public TimeBins bins() {
    return bins;
  }

  @Override
  public void packet(EventPacket packet) {
    for (int i = 0; i < packet.size(); i++) {
      long timeUs = packet.timeUs(i);
      if (baseUs == StreamNotification.NO_TIME_US) {
        baseUs = timeUs - elapsedUs;
        firstUs = firstUs == StreamNotification.NO_TIME_US ? timeUs : firstUs;
      }
      lastUs = timeUs;
      elapsedUs = timeUs - baseUs;
      bins.add(elapsedUs, 1);
    }
  }

  @Override
  public void notified(StreamNotification notification) {
    if (notification.restartsTime()) {
      baseUs = StreamNotification.NO_TIME_US;
    }
  }

  /**
   * The rate as block characters.
   *
   * @return one for each time bin, a space for a bin without events
   */
  public String line() {
    StringBuilder line = new StringBuilder();
    for (int bin = 0; bin < bins.size(); bin++) {
      double rate = bins.rateHz(bin);
      int height = (int) Math.ceil(BLOCKS.length() * rate / maxHz());
      line.append(rate == 0 ? ' ' : BLOCKS.charAt(height - 1));
    }
    return line.toString();
  }

  /**
   * The highest rate of any of the bins.
   *
   * @return events per second
   */
  public double maxHz() {
    return IntStream.range(0, bins.size()).mapToDouble(bins::rateHz).max().orElse(0);
  }
}
