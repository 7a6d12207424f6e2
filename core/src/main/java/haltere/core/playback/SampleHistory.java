package haltere.core.playback;

import haltere.core.event.Frame;
import haltere.core.event.SensorSample;
import java.util.ArrayList;
import java.util.List;

/**
 * A bounded buffer of the samples between the events of an {@link EventHistory}. When it is full,
 * the oldest are discarded.
 *
 * <p>Thread rule: one thread at a time.
 */
final class SampleHistory {
  /**
   * Capacity for 15 s of a camera's frames of 346 by 260 pixels at 25 Hz, and its other samples.
   */
  static final long MAX_BYTES = 72 << 20;

  /** Approximate size of a sample without the pixels of a frame. */
  private static final int BYTES_EACH = 96;

  /**
   * A sample and its position among events.
   *
   * @param sample the sample
   * @param offsetUs elapsed time minus time on the source's clock, microseconds
   * @param eventsBefore number of events before it since the history began
   * @param afterNotification whether it came after the notification between the same two events
   */
  record Entry(SensorSample sample, long offsetUs, long eventsBefore, boolean afterNotification) {
    long elapsedUs() {
      return sample.timeUs() + offsetUs;
    }
  }

  private final long maxBytes;
  private final List<Entry> all = new ArrayList<>();
  private long bytes;
  private int next;

  /** An empty buffer of about this capacity, bytes. */
  SampleHistory(long maxBytes) {
    this.maxBytes = maxBytes;
  }

  private static long bytes(Entry entry) {
    return entry.sample() instanceof Frame frame
        ? BYTES_EACH
            + (long) frame.width() * frame.height() * frame.channels() * frame.depth().bytes()
        : BYTES_EACH;
  }

  /** Appends a sample; the read position moves to the end. */
  void add(Entry entry) {
    all.add(entry);
    bytes += bytes(entry);
    if (bytes > maxBytes) {
      // Several at a time, because all others move.
      forget(1 + all.size() / 16);
    }
    toEnd();
  }

  /** Discards the samples before an event; it is given by the number of events before it. */
  void removeBefore(long event) {
    int count = 0;
    while (count < all.size() && all.get(count).eventsBefore() <= event) {
      count++;
    }
    forget(count);
    toEnd();
  }

  private void forget(int count) {
    List<Entry> oldest = all.subList(0, Math.min(count, all.size()));
    oldest.forEach(entry -> bytes -= bytes(entry));
    oldest.clear();
  }

  void clear() {
    forget(all.size());
    toEnd();
  }

  void toEnd() {
    next = all.size();
  }

  boolean atEnd() {
    return next == all.size();
  }

  /** Moves to the first sample that is neither before an event nor before a position. */
  void read(long event, long elapsedUs) {
    next = 0;
    while (!atEnd() && (peek().eventsBefore() < event || peek().elapsedUs() < elapsedUs)) {
      next++;
    }
  }

  /** The next sample; must not be at the end. */
  Entry peek() {
    return all.get(next);
  }

  void skip() {
    next++;
  }

  /** Read position, for {@link #returnTo}. */
  int index() {
    return next;
  }

  void returnTo(int index) {
    next = index;
  }
}
