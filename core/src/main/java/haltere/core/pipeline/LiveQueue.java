package haltere.core.pipeline;

import haltere.core.event.EventPacket;
import haltere.core.event.Frame;
import haltere.core.event.SensorSample;
import haltere.core.stream.DataLost;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamNotification;
import java.util.LinkedList;
import java.util.List;

/**
 * The queue of a {@link LiveBuffer}, in the order of the stream, with a gap wherever events are
 * missing.
 *
 * <p>Thread rule: under the lock of its buffer only.
 */
final class LiveQueue {
  /** Maximum size of waiting frames, inertial samples and triggers. */
  private static final long MAX_SAMPLE_BYTES = 32 << 20;

  private static final int BYTES_PER_READING = 256;

  /** Missing events at a position of the stream. */
  private static final class LossMark {
    long events;
  }

  private final String place;
  // EventPacket, SensorSample, StreamNotification or LossMark; the last one is never a mark
  private final List<Object> waiting = new LinkedList<>(); // used at its ends
  private long lastTakenUs = StreamNotification.NO_TIME_US;
  private int packets;
  private int events;
  private int peakPackets;
  private int samples;
  private long sampleBytes;

  /**
   * An empty queue.
   *
   * @param place who loses events, in words for users
   */
  LiveQueue(String place) {
    this.place = place;
  }

  /** Number of waiting packets. */
  int packets() {
    return packets;
  }

  /** Number of waiting events. */
  int events() {
    return events;
  }

  /** Counts events that were added to the {@link #lastPacket() last packet}. */
  void lastGrew(int more) {
    events += more;
  }

  /** Maximum number of waiting packets so far. */
  int peakPackets() {
    return peakPackets;
  }

  /** Number of waiting samples. */
  int samples() {
    return samples;
  }

  /** Whether another sample may wait; one always may. */
  boolean hasRoomForSample() {
    return samples == 0 || sampleBytes < MAX_SAMPLE_BYTES;
  }

  /** The last element if it is a packet, else null. */
  EventPacket lastPacket() {
    int last = waiting.size() - 1;
    return last >= 0 && waiting.get(last) instanceof EventPacket packet ? packet : null;
  }

  void add(EventPacket packet) {
    waiting.add(packet);
    packets++;
    events += packet.size();
    peakPackets = Math.max(peakPackets, packets);
  }

  void add(SensorSample sample) {
    waiting.add(sample);
    samples++;
    sampleBytes += bytes(sample);
  }

  /** Adds a notification; a reset directly after a reset replaces it. */
  void add(StreamNotification notification) {
    int last = waiting.size() - 1;
    if (notification instanceof Reset next
        && last >= 0
        && waiting.get(last) instanceof Reset before) {
      waiting.set(last, new Reset(next.cause(), before.lastUs(), next.nextUs()));
    } else {
      waiting.add(notification);
    }
  }

  /** Adds a gap at the end. */
  void addGap(int events) {
    addGap(waiting.size(), events);
  }

  /** Replaces the oldest packet by a gap and returns it; null if there is none. */
  EventPacket dropOldest() {
    for (int i = 0; i < waiting.size(); i++) {
      if (waiting.get(i) instanceof EventPacket oldest) {
        waiting.remove(i);
        packets--;
        events -= oldest.size();
        addGap(i, oldest.size());
        return oldest;
      }
    }
    return null;
  }

  /** Adds a gap before the element at an index. */
  private void addGap(int index, int events) {
    LossMark gap;
    if (index > 0 && waiting.get(index - 1) instanceof LossMark before) {
      gap = before;
      if (index < waiting.size() && waiting.get(index) instanceof LossMark after) {
        gap.events += after.events;
        waiting.remove(index);
      }
    } else if (index < waiting.size() && waiting.get(index) instanceof LossMark after) {
      gap = after;
    } else {
      gap = new LossMark();
      waiting.add(index, gap);
    }
    gap.events += events;
  }

  /** A gap waits for the next element, which may extend it and has the time of its end. */
  boolean hasNext() {
    return waiting.size() > 1 || (!waiting.isEmpty() && !(waiting.get(0) instanceof LossMark));
  }

  /** Takes a packet, a sample or a notification, if there {@link #hasNext() is one}. */
  Object take() {
    Object next = waiting.remove(0);
    if (next instanceof LossMark gap) {
      long toUs =
          waiting.get(0) instanceof EventPacket packet
              ? packet.firstTimeUs()
              : StreamNotification.NO_TIME_US;
      return new DataLost(-1, gap.events, lastTakenUs, toUs, place);
    }
    if (next instanceof EventPacket packet) {
      packets--;
      events -= packet.size();
      lastTakenUs = packet.lastTimeUs();
    } else if (next instanceof SensorSample sample) {
      samples--;
      sampleBytes -= bytes(sample);
    } else if (((StreamNotification) next).endsContinuity()) {
      lastTakenUs = StreamNotification.NO_TIME_US;
    }
    return next;
  }

  /** Removes everything; returns the number of removed events. */
  long clear() {
    int cleared = events;
    waiting.clear();
    packets = 0;
    events = 0;
    samples = 0;
    sampleBytes = 0;
    return cleared;
  }

  private static long bytes(SensorSample sample) {
    return BYTES_PER_READING + (sample instanceof Frame frame ? frame.rows().capacity() : 0);
  }
}
