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
 * A bounded buffer of the newest events of a stream, 8 bytes each, with the notifications and
 * samples between them. When it is full, the oldest {@value #CHUNK_EVENTS} events are discarded.
 * Memory is allocated as events arrive, and reused.
 *
 * <p>Positions are on the elapsed timeline, in microseconds. Thread rule: one thread at a time.
 */
final class EventHistory {
  /** Events that are discarded together. */
  static final int CHUNK_EVENTS = 8192;

  /** Consecutive events of one stretch of the source's clock, and the notification before them. */
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

    /** Appends events as far as they fit, at least the first; returns the index after the last. */
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

    /** A method of its own, so that the compiler vectorises the loop. */
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

  private final int maxChunks;
  private final List<Chunk> chunks = new ArrayList<>();
  private final ArrayDeque<Chunk> spare = new ArrayDeque<>();
  private final SampleHistory samples;
  private StreamNotification pending;

  private long events;

  // Read position.
  private int chunk;
  private int index;
  private boolean notificationGiven;

  /**
   * A history without events.
   *
   * @param maxEvents approximate capacity, events
   */
  EventHistory(int maxEvents) {
    this(maxEvents, SampleHistory.MAX_BYTES);
  }

  /**
   * A history without events.
   *
   * @param maxEvents approximate capacity, events
   * @param maxSampleBytes approximate capacity for samples, bytes
   */
  EventHistory(int maxEvents, long maxSampleBytes) {
    maxChunks = Math.max(2, maxEvents / CHUNK_EVENTS);
    samples = new SampleHistory(maxSampleBytes);
  }

  boolean isEmpty() {
    return chunks.isEmpty();
  }

  /** Events so far, including discarded ones. */
  long events() {
    return events;
  }

  /** Position of the oldest event; the history must not be empty. */
  long fromUs() {
    return chunks.get(0).fromUs();
  }

  /** Elapsed time minus time of the oldest event; the history must not be empty. */
  long firstOffsetUs() {
    return chunks.get(0).offsetUs;
  }

  /** Position of the newest event; the history must not be empty. */
  long lastUs() {
    return chunks.get(chunks.size() - 1).lastUs();
  }

  /** Discards everything. */
  void clear() {
    spare.addAll(chunks);
    chunks.clear();
    samples.clear();
    pending = null;
    toEnd();
  }

  // ---- Writing

  /** Appends events; the read position must be at the end. */
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
    if (chunks.size() == maxChunks) {
      spare.add(chunks.remove(0));
      samples.removeBefore(chunks.get(0).eventsBefore);
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

  /** Appends a notification; of several between the same events a reset is kept, or the last. */
  void append(StreamNotification notification) {
    if (!(pending instanceof Reset)) {
      pending = notification;
    }
    toEnd();
  }

  /** Appends a sample. */
  void append(SensorSample sample, long offsetUs) {
    samples.add(new SampleHistory.Entry(sample, offsetUs, events, pending != null));
    toEnd();
  }

  // ---- Reading

  private void toEnd() {
    chunk = chunks.size();
    index = 0;
    notificationGiven = true;
    samples.toEnd();
  }

  /** Number of events before the one that is read next. */
  private long nextEvent() {
    return chunk < chunks.size() ? chunks.get(chunk).eventsBefore + index : events;
  }

  /** Moves to the first event or sample at or after a position, or to the end. */
  void read(long elapsedUs) {
    chunk = 0;
    while (chunk < chunks.size() && chunks.get(chunk).lastUs() < elapsedUs) {
      chunk++;
    }
    index = chunk < chunks.size() ? chunks.get(chunk).indexAtOrAfter(elapsedUs) : 0;
    notificationGiven = true;
    samples.read(nextEvent(), elapsedUs);
  }

  /** Whether everything has been read. */
  boolean atEnd() {
    return chunk == chunks.size() && samples.atEnd();
  }

  /**
   * Passes on the next events, sample or notification; must not be at the end.
   *
   * @param piece receives the events; its content is dropped
   * @param offset receives elapsed time minus time of the next element, before the element
   * @param handler receives the element
   */
  void next(EventPacket piece, LongConsumer offset, StreamHandler handler) {
    if (isSampleNext()) {
      SampleHistory.Entry next = samples.peek();
      samples.skip();
      offset.accept(next.offsetUs());
      handler.sample(next.sample());
      return;
    }
    StreamNotification notification = notificationGiven ? null : chunks.get(chunk).before;
    notificationGiven = true;
    if (notification != null) {
      handler.notified(notification);
    } else {
      offset.accept(readInto(piece));
      handler.packet(piece);
    }
  }

  private boolean isSampleNext() {
    if (samples.atEnd()) {
      return false;
    }
    SampleHistory.Entry next = samples.peek();
    return next.eventsBefore() < nextEvent()
        || next.eventsBefore() == nextEvent() && (notificationGiven || !next.afterNotification());
  }

  /** Reads events up to the next sample; returns their elapsed time minus time. */
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
      notificationGiven = chunk == chunks.size();
    }
    return read.offsetUs;
  }

  // ---- Copies

  /** A copy of a half-open interval, with the read position at its start. */
  EventHistory copy(long fromUs, long toUs) {
    int chunkBefore = chunk;
    int indexBefore = index;
    boolean notificationGivenBefore = notificationGiven;
    int sampleBefore = samples.index();
    Copy copy = new Copy(toUs);
    EventPacket piece = new EventPacket(PlaybackEngine.CHUNK_EVENTS);
    read(fromUs);
    while (!atEnd() && !copy.full) {
      next(piece, copy, copy);
    }
    chunk = chunkBefore;
    index = indexBefore;
    notificationGiven = notificationGivenBefore;
    samples.returnTo(sampleBefore);
    copy.target.read(Long.MIN_VALUE);
    return copy.target;
  }

  /** Copies everything before a position. */
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
