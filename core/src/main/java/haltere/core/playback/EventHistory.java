package haltere.core.playback;

import haltere.core.event.EventPacket;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamNotification;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;

/**
 * The newest events of a stream and the notifications between them, 8 bytes an event, in bounded
 * memory: where there is no more room the oldest are forgotten, some thousand at a time. Memory is
 * taken as events come, and used again.
 *
 * <p>Places are on the elapsed timeline, in microseconds. Thread rule: one thread at a time.
 */
final class EventHistory {
  /** Events that are forgotten together. */
  static final int CHUNK_EVENTS = 8192;

  /** Events in a row, of one stretch of the source's clock, with what was said before them. */
  private static final class Chunk {
    private final int[] sinceFirstUs = new int[CHUNK_EVENTS];
    private final int[] addresses = new int[CHUNK_EVENTS];
    private int count;
    private long firstTimeUs;
    private long offsetUs;
    private StreamNotification before;

    long fromUs() {
      return firstTimeUs + offsetUs;
    }

    long timeUs(int index) {
      return firstTimeUs + sinceFirstUs[index];
    }

    long lastUs() {
      return timeUs(count - 1) + offsetUs;
    }

    boolean takes(long timeUs, long offset) {
      return count < CHUNK_EVENTS
          && offset == offsetUs
          && timeUs - firstTimeUs <= Integer.MAX_VALUE
          && timeUs >= firstTimeUs;
    }

    int indexAtOrAfter(long elapsedUs) {
      int low = 0;
      int high = count;
      while (low < high) {
        int middle = (low + high) >>> 1;
        if (timeUs(middle) + offsetUs < elapsedUs) {
          low = middle + 1;
        } else {
          high = middle;
        }
      }
      return low;
    }
  }

  private final int mostChunks;
  private final List<Chunk> chunks = new ArrayList<>();
  private final ArrayDeque<Chunk> spare = new ArrayDeque<>();
  private StreamNotification pending;

  // Where reading is.
  private int chunk;
  private int index;
  private boolean noticeGiven;

  /**
   * A history without events.
   *
   * @param mostEvents about so many are kept
   */
  EventHistory(int mostEvents) {
    mostChunks = Math.max(2, mostEvents / CHUNK_EVENTS);
  }

  boolean isEmpty() {
    return chunks.isEmpty();
  }

  /** Place of the oldest event; only if there is one. */
  long fromUs() {
    return chunks.get(0).fromUs();
  }

  /** Elapsed time less time of the oldest event; only if there is one. */
  long firstOffsetUs() {
    return chunks.get(0).offsetUs;
  }

  /** Place of the newest event; only if there is one. */
  long lastUs() {
    return chunks.get(chunks.size() - 1).lastUs();
  }

  /** Forgets everything. */
  void clear() {
    spare.addAll(chunks);
    chunks.clear();
    pending = null;
    toEnd();
  }

  // ---- Writing

  /** Keeps events; reading must be at the end. */
  void append(EventPacket packet, long offsetUs) {
    long[] times = packet.timesUs();
    int[] addresses = packet.addresses();
    Chunk last = pending == null && !isEmpty() ? chunks.get(chunks.size() - 1) : null;
    for (int i = 0; i < packet.size(); i++) {
      if (last == null || !last.takes(times[i], offsetUs)) {
        last = begin(times[i], offsetUs);
      }
      last.sinceFirstUs[last.count] = (int) (times[i] - last.firstTimeUs);
      last.addresses[last.count++] = addresses[i];
    }
    toEnd();
  }

  private Chunk begin(long timeUs, long offsetUs) {
    if (chunks.size() == mostChunks) {
      spare.add(chunks.remove(0));
    }
    Chunk begun = spare.isEmpty() ? new Chunk() : spare.pop();
    begun.count = 0;
    begun.firstTimeUs = timeUs;
    begun.offsetUs = offsetUs;
    begun.before = pending;
    pending = null;
    chunks.add(begun);
    return begun;
  }

  /** Keeps a notification; of several between the same events the one that matters most. */
  void append(StreamNotification notification) {
    if (!(pending instanceof Reset)) {
      pending = notification;
    }
    toEnd();
  }

  // ---- Reading

  private void toEnd() {
    chunk = chunks.size();
    index = 0;
    noticeGiven = true;
  }

  /** Reads on at the first event at or after a place, or at the end. */
  void read(long elapsedUs) {
    chunk = 0;
    while (chunk < chunks.size() && chunks.get(chunk).lastUs() < elapsedUs) {
      chunk++;
    }
    index = chunk < chunks.size() ? chunks.get(chunk).indexAtOrAfter(elapsedUs) : 0;
    noticeGiven = true;
  }

  /** Whether all that is kept has been read. */
  boolean atEnd() {
    return chunk == chunks.size();
  }

  /** The notification that comes next, or null if events do; only if not at the end. */
  StreamNotification nextNotice() {
    StreamNotification next = noticeGiven ? null : chunks.get(chunk).before;
    noticeGiven = true;
    return next;
  }

  /**
   * Reads events.
   *
   * @param target receives at most {@value PlaybackEngine#CHUNK_EVENTS}, in place of what it has
   * @return elapsed time less time of them
   */
  long readInto(EventPacket target) {
    Chunk read = chunks.get(chunk);
    int to = Math.min(read.count, index + PlaybackEngine.CHUNK_EVENTS);
    target.clear();
    for (int i = index; i < to; i++) {
      target.append(read.timeUs(i), read.addresses[i]);
    }
    index = to;
    if (index == read.count) {
      chunk++;
      index = 0;
      noticeGiven = false;
    }
    return read.offsetUs;
  }

  // ---- Copies

  /** What is kept of a half-open stretch, to be read from its start. */
  EventHistory copy(long fromUs, long toUs) {
    EventHistory copy = new EventHistory(Integer.MAX_VALUE);
    EventPacket part = new EventPacket(CHUNK_EVENTS);
    for (Chunk kept : chunks) {
      int from = kept.indexAtOrAfter(fromUs);
      int to = Math.max(from, kept.indexAtOrAfter(toUs));
      if (kept.before != null && from == 0 && !copy.isEmpty()) {
        copy.append(kept.before);
      }
      if (to > from) {
        part.clear();
        for (int i = from; i < to; i++) {
          part.append(kept.timeUs(i), kept.addresses[i]);
        }
        copy.append(part, kept.offsetUs);
      }
    }
    copy.read(Long.MIN_VALUE);
    return copy;
  }
}
