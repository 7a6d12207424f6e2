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
 * What waits in a {@link LiveBuffer}, in the order of the stream, with a note wherever events are
 * missing.
 *
 * <p>Thread rule: under the lock of its buffer only.
 */
final class LiveQueue {
  /** So much of frames, samples and triggers may wait. */
  private static final long MAX_READING_BYTES = 32 << 20;

  private static final int BYTES_PER_READING = 256;

  /** What is missing at a place of the stream. */
  private static final class Gap {
    long events;
  }

  private final String place;
  // EventPacket, SensorSample, StreamNotification or Gap; a gap is never at the end of what may be
  // taken.
  private final List<Object> waiting = new LinkedList<>(); // used at its ends
  private long lastTakenUs = StreamNotification.NO_TIME_US;
  private int packets;
  private int events;
  private int mostPackets;
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

  /** Packets that wait. */
  int packets() {
    return packets;
  }

  /** Events that wait. */
  int events() {
    return events;
  }

  /** Counts events that were added to the {@link #lastPacket() last packet}. */
  void grew(int more) {
    events += more;
  }

  /** The most packets that ever waited. */
  int mostPackets() {
    return mostPackets;
  }

  /** Samples that wait. */
  int samples() {
    return samples;
  }

  /** Whether another sample may wait; one always may. */
  boolean hasRoomForSample() {
    return samples == 0 || sampleBytes < MAX_READING_BYTES;
  }

  /** The packet that came last, or null if it was something else that did. */
  EventPacket lastPacket() {
    int last = waiting.size() - 1;
    return last >= 0 && waiting.get(last) instanceof EventPacket packet ? packet : null;
  }

  void add(EventPacket packet) {
    waiting.add(packet);
    packets++;
    events += packet.size();
    mostPackets = Math.max(mostPackets, packets);
  }

  void add(SensorSample sample) {
    waiting.add(sample);
    samples++;
    sampleBytes += bytes(sample);
  }

  /** Adds a notification; a reset straight after a reset takes its place. */
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

  /** Notes that events are missing after all that waits. */
  void addGap(int events) {
    addGap(waiting.size(), events);
  }

  /** Takes the oldest packet out and notes that its events are missing; null if there is none. */
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

  /** Notes that events are missing before what stands at an index. */
  private void addGap(int index, int events) {
    Gap gap;
    if (index > 0 && waiting.get(index - 1) instanceof Gap before) {
      gap = before;
      if (index < waiting.size() && waiting.get(index) instanceof Gap after) {
        gap.events += after.events;
        waiting.remove(index);
      }
    } else if (index < waiting.size() && waiting.get(index) instanceof Gap after) {
      gap = after;
    } else {
      gap = new Gap();
      waiting.add(index, gap);
    }
    gap.events += events;
  }

  /** A gap waits for the next element, which may extend it and has the time of its end. */
  boolean hasNext() {
    return waiting.size() > 1 || (!waiting.isEmpty() && !(waiting.get(0) instanceof Gap));
  }

  /** Takes a packet, a sample or a notification, if there {@link #hasNext() is one}. */
  Object take() {
    Object next = waiting.remove(0);
    if (next instanceof Gap gap) {
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

  /** Throws away all that waits; returns how many events that were. */
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
