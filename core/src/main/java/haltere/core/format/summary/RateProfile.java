package haltere.core.format.summary;

import haltere.core.event.EventPacket;
import haltere.core.format.RecordingReader;
import haltere.core.format.TimeSegment;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.util.List;

/**
 * The event rate over a recording's elapsed timeline, on which its segments are contiguous, in bins
 * of equal length.
 *
 * <p>Thread rule: immutable.
 *
 * @since 0.1
 */
public final class RateProfile {
  private final long durationUs;
  private final long[] events;

  private RateProfile(long durationUs, long[] events) {
    this.durationUs = durationUs;
    this.events = events;
  }

  /**
   * Reads a recording from its start to its end. Suitable for a background thread with its own
   * reader.
   *
   * @param reader at its start; at its end afterwards
   * @param bins number of bins, at least 1
   * @return the profile
   * @throws InterruptedIOException if the thread is interrupted
   * @throws IOException if the file can no longer be read
   */
  public static RateProfile scan(RecordingReader reader, int bins) throws IOException {
    if (bins < 1) {
      throw new IllegalArgumentException("a profile has at least one bin, not " + bins);
    }
    Collector scan = new Collector(reader.segments(), bins);
    while (reader.next(scan)) {
      // keeps the user interface responsive
      Thread.yield();
      if (Thread.currentThread().isInterrupted()) {
        throw new InterruptedIOException("interrupted while reading " + reader.path());
      }
    }
    return scan.profile();
  }

  /**
   * Length of the timeline.
   *
   * @return microseconds
   */
  public long durationUs() {
    return durationUs;
  }

  /**
   * Number of bins.
   *
   * @return at least 1
   */
  public int bins() {
    return events.length;
  }

  /**
   * Rate in a bin.
   *
   * @param bin 0 to {@link #bins()} - 1
   * @return events per second; 0 for a recording without duration
   */
  public double eventsPerSecond(int bin) {
    return durationUs == 0 ? 0 : events[bin] * 1e6 * events.length / durationUs;
  }

  /**
   * Counts the events of a recording that is read from its start to its end.
   *
   * <p>Thread rule: one thread at a time.
   */
  public static final class Collector implements StreamHandler {
    private final List<TimeSegment> segments;
    private final long durationUs;
    private final long[] events;
    private int segment;
    private boolean inSegment;
    private long segmentFirstUs;
    private long segmentStartUs;

    /**
     * A collector without events.
     *
     * @param segments of the recording
     * @param bins number of bins, at least 1
     */
    public Collector(List<TimeSegment> segments, int bins) {
      this.segments = segments;
      durationUs = segments.stream().mapToLong(TimeSegment::durationUs).sum();
      events = new long[bins];
    }

    /**
     * Elapsed time of a time in the current segment.
     *
     * @param timeUs time on the recording's clock, microseconds
     * @return microseconds since the recording's start
     */
    public long elapsedUs(long timeUs) {
      long firstUs =
          inSegment || segment >= segments.size()
              ? segmentFirstUs
              : segments.get(segment).firstUs();
      return segmentStartUs + timeUs - firstUs;
    }

    /**
     * The profile of the events so far.
     *
     * @return a copy
     */
    public RateProfile profile() {
      return new RateProfile(durationUs, events.clone());
    }

    @Override
    public void packet(EventPacket packet) {
      int size = packet.size();
      if (size == 0) {
        return;
      }
      if (!inSegment) {
        inSegment = true;
        segmentFirstUs = packet.firstTimeUs();
      }
      double binsPerUs = durationUs == 0 ? 0 : events.length / (double) durationUs;
      long offsetUs = segmentStartUs - segmentFirstUs;
      int last = events.length - 1;
      for (int i = 0; i < size; i++) {
        int bin = (int) ((packet.timeUs(i) + offsetUs) * binsPerUs);
        events[Math.max(0, Math.min(bin, last))]++;
      }
    }

    @Override
    public void notified(StreamNotification notification) {
      if (notification instanceof Reset && inSegment) {
        inSegment = false;
        if (segment < segments.size()) {
          segmentStartUs += segments.get(segment++).durationUs();
        }
      }
    }
  }
}
