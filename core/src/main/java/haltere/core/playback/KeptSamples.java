package haltere.core.playback;

import haltere.core.event.Frame;
import haltere.core.event.SensorSample;
import java.util.ArrayList;
import java.util.List;

/**
 * Samples between the events of an {@link EventHistory}, with their places, in bounded memory:
 * where there is no more room the oldest are forgotten.
 *
 * <p>Thread rule: one thread at a time.
 */
final class KeptSamples {
  /**
   * Room for 15 s of a camera's frames of 346 by 260 pixels, 25 a second, and what else it tells.
   */
  static final long MAX_BYTES = 72 << 20;

  /** What a sample takes beside the pixels of a frame, about. */
  private static final int BYTES_EACH = 96;

  /**
   * A sample in its place.
   *
   * @param sample what was told
   * @param offsetUs elapsed time less time on the source's clock, microseconds
   * @param eventsBefore how many events came before it since the history began
   * @param afterNotice whether it came behind what was said between the same two events
   */
  record Kept(SensorSample sample, long offsetUs, long eventsBefore, boolean afterNotice) {
    long elapsedUs() {
      return sample.timeUs() + offsetUs;
    }
  }

  private final long mostBytes;
  private final List<Kept> all = new ArrayList<>();
  private long bytes;
  private int next;

  /** Keeps about so many bytes. */
  KeptSamples(long mostBytes) {
    this.mostBytes = mostBytes;
  }

  private static long bytes(Kept kept) {
    return kept.sample() instanceof Frame frame
        ? BYTES_EACH
            + (long) frame.width() * frame.height() * frame.channels() * frame.depth().bytes()
        : BYTES_EACH;
  }

  /** Keeps one more; reading continues at the end. */
  void add(Kept kept) {
    all.add(kept);
    bytes += bytes(kept);
    if (bytes > mostBytes) {
      // several at a time, because all that are left move
      forget(1 + all.size() / 16);
    }
    toEnd();
  }

  /** Forgets those before an event, which is given by how many came before it. */
  void forgetBefore(long event) {
    int count = 0;
    while (count < all.size() && all.get(count).eventsBefore() <= event) {
      count++;
    }
    forget(count);
    toEnd();
  }

  private void forget(int count) {
    List<Kept> oldest = all.subList(0, Math.min(count, all.size()));
    oldest.forEach(kept -> bytes -= bytes(kept));
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

  /** Reads on at the first one that is neither before an event nor before a place. */
  void read(long event, long elapsedUs) {
    next = 0;
    while (!atEnd() && (peek().eventsBefore() < event || peek().elapsedUs() < elapsedUs)) {
      next++;
    }
  }

  /** The one that comes next; only if not at the end. */
  Kept peek() {
    return all.get(next);
  }

  void skip() {
    next++;
  }

  /** Where reading is, for {@link #returnTo}. */
  int place() {
    return next;
  }

  void returnTo(int place) {
    next = place;
  }
}
