package haltere.core.playback;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.function.LongConsumer;

/**
 * The newest events of a stream, and the notifications and samples between them, 8 bytes an event,
 * in bounded memory: where there is no more room the oldest are forgotten, some thousand at a time.
 * Memory is taken as events come, and used again.
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
    private long eventsBefore;
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

    /** Keeps events, the first of which it takes, as far as they fit; index behind the last. */
    int append(EventPacket packet, int from) {
      int to = Math.min(packet.size(), from + CHUNK_EVENTS - count);
      if (packet.timeUs(to - 1) - firstTimeUs > Integer.MAX_VALUE) {
        to = packet.indexAtOrAfter(firstTimeUs + Integer.MAX_VALUE + 1L, from);
      }
      copyTimes(packet.timesUs(), from, to);
      System.arraycopy(packet.addresses(), from, addresses, count, to - from);
      count += to - from;
      return to;
    }

    /** By itself, the compiler makes vectors of this loop. */
    private void copyTimes(long[] timesUs, int from, int to) {
      int[] target = sinceFirstUs;
      int shift = count - from;
      long first = firstTimeUs;
      for (int i = from; i < to; i++) {
        target[shift + i] = (int) (timesUs[i] - first);
      }
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
  private final KeptSamples samples;
  private StreamNotification pending;

  /** Events so far, those forgotten included. */
  private long events;

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
    this(mostEvents, KeptSamples.MAX_BYTES);
  }

  /**
   * A history without events.
   *
   * @param mostEvents about so many are kept
   * @param mostSampleBytes about so much is kept of samples
   */
  EventHistory(int mostEvents, long mostSampleBytes) {
    mostChunks = Math.max(2, mostEvents / CHUNK_EVENTS);
    samples = new KeptSamples(mostSampleBytes);
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
    samples.clear();
    pending = null;
    toEnd();
  }

  // ---- Writing

  /** Keeps events; reading must be at the end. */
  void append(EventPacket packet, long offsetUs) {
    long[] times = packet.timesUs();
    Chunk last = pending == null && !isEmpty() ? chunks.get(chunks.size() - 1) : null;
    int from = 0;
    while (from < packet.size()) {
      if (last == null || !last.takes(times[from], offsetUs)) {
        last = begin(times[from], offsetUs);
      }
      int to = last.append(packet, from);
      events += to - from;
      from = to;
    }
    toEnd();
  }

  private Chunk begin(long timeUs, long offsetUs) {
    if (chunks.size() == mostChunks) {
      spare.add(chunks.remove(0));
      samples.forgetBefore(chunks.get(0).eventsBefore);
    }
    Chunk begun = spare.isEmpty() ? new Chunk() : spare.pop();
    begun.count = 0;
    begun.firstTimeUs = timeUs;
    begun.offsetUs = offsetUs;
    begun.eventsBefore = events;
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

  /** Keeps a sample. */
  void append(SensorSample sample, long offsetUs) {
    samples.add(new KeptSamples.Kept(sample, offsetUs, events, pending != null));
    toEnd();
  }

  // ---- Reading

  private void toEnd() {
    chunk = chunks.size();
    index = 0;
    noticeGiven = true;
    samples.toEnd();
  }

  /** How many events came before the one that is read next. */
  private long nextEvent() {
    return chunk < chunks.size() ? chunks.get(chunk).eventsBefore + index : events;
  }

  /** Reads on at the first event or sample at or after a place, or at the end. */
  void read(long elapsedUs) {
    chunk = 0;
    while (chunk < chunks.size() && chunks.get(chunk).lastUs() < elapsedUs) {
      chunk++;
    }
    index = chunk < chunks.size() ? chunks.get(chunk).indexAtOrAfter(elapsedUs) : 0;
    noticeGiven = true;
    samples.read(nextEvent(), elapsedUs);
  }

  /** Whether all that is kept has been read. */
  boolean atEnd() {
    return chunk == chunks.size() && samples.atEnd();
  }

  /**
   * Hands over what comes next; only if not at the end.
   *
   * @param piece for events; what it has is dropped
   * @param place told elapsed time less time of what comes next, before that is handed over
   */
  void next(EventPacket piece, LongConsumer place, StreamHandler handler) {
    if (isSampleNext()) {
      KeptSamples.Kept next = samples.peek();
      samples.skip();
      place.accept(next.offsetUs());
      handler.sample(next.sample());
      return;
    }
    StreamNotification notice = noticeGiven ? null : chunks.get(chunk).before;
    noticeGiven = true;
    if (notice != null) {
      handler.notified(notice);
    } else {
      place.accept(readInto(piece));
      handler.packet(piece);
    }
  }

  private boolean isSampleNext() {
    if (samples.atEnd()) {
      return false;
    }
    KeptSamples.Kept next = samples.peek();
    return next.eventsBefore() < nextEvent()
        || next.eventsBefore() == nextEvent() && (noticeGiven || !next.afterNotice());
  }

  /** Reads events up to the next sample; elapsed time less time of them. */
  private long readInto(EventPacket target) {
    Chunk read = chunks.get(chunk);
    int to = Math.min(read.count, index + PlaybackEngine.CHUNK_EVENTS);
    if (!samples.atEnd()) {
      to = (int) Math.min(to, samples.peek().eventsBefore() - read.eventsBefore);
    }
    target.clear();
    for (int i = index; i < to; i++) {
      target.append(read.timeUs(i), read.addresses[i]);
    }
    index = to;
    if (index == read.count) {
      chunk++;
      index = 0;
      noticeGiven = chunk == chunks.size();
    }
    return read.offsetUs;
  }

  // ---- Copies

  /** What is kept of a half-open stretch, to be read from its start. */
  EventHistory copy(long fromUs, long toUs) {
    int chunkBefore = chunk;
    int indexBefore = index;
    boolean noticeBefore = noticeGiven;
    int sampleBefore = samples.place();
    Copy copy = new Copy(toUs);
    EventPacket piece = new EventPacket(PlaybackEngine.CHUNK_EVENTS);
    read(fromUs);
    while (!atEnd() && !copy.full) {
      next(piece, copy, copy);
    }
    chunk = chunkBefore;
    index = indexBefore;
    noticeGiven = noticeBefore;
    samples.returnTo(sampleBefore);
    copy.target.read(Long.MIN_VALUE);
    return copy.target;
  }

  /** Keeps what comes before a place. */
  private static final class Copy implements StreamHandler, LongConsumer {
    private final EventHistory target = new EventHistory(Integer.MAX_VALUE, Long.MAX_VALUE);
    private final long toUs;
    private long offsetUs;
    private boolean full;

    Copy(long toUs) {
      this.toUs = toUs;
    }

    @Override
    public void accept(long newOffsetUs) {
      offsetUs = newOffsetUs;
    }

    @Override
    public void packet(EventPacket packet) {
      int end = packet.indexAtOrAfter(toUs - offsetUs);
      full = end < packet.size();
      packet.truncate(end);
      target.append(packet, offsetUs);
    }

    @Override
    public void sample(SensorSample sample) {
      if (sample.timeUs() + offsetUs < toUs) {
        target.append(sample, offsetUs);
      }
    }

    @Override
    public void notified(StreamNotification notification) {
      if (!target.isEmpty()) {
        target.append(notification);
      }
    }
  }
}
