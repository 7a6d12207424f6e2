package haltere.core.pipeline;

import haltere.core.event.EventPacket;
import haltere.core.event.Frame;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorReading;
import haltere.core.stream.DataLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.EventSource;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.InterruptedIOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/**
 * Takes one stream from the thread that makes it to the thread that processes it, through a fixed
 * number of packets. Where they do not suffice, its {@link OverflowPolicy} says what happens;
 * events that are dropped are counted, and at their place in the stream stands one {@link DataLost}
 * for all that are missing there. Notifications are never dropped; a reset straight after a reset
 * takes its place.
 *
 * <p>Thread rule: one producer uses it as a {@link StreamHandler}, one consumer as an {@link
 * EventSource}; the counts may be read from any thread.
 */
public final class LiveBuffer implements StreamHandler, EventSource {
  /** So much of frames, samples and triggers may wait. */
  private static final long MAX_READING_BYTES = 32 << 20;

  private static final int BYTES_PER_READING = 256;

  /** What is missing at a place of the stream. */
  private static final class Gap {
    long events;
  }

  private final SensorGeometry geometry;
  private final int capacity;
  private final OverflowPolicy policy;
  private final String place;
  private final boolean gathering;
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed = lock.newCondition();
  private final ArrayDeque<EventPacket> free = new ArrayDeque<>();
  // EventPacket, SensorReading, StreamNotification or Gap; a gap is never at the end of what may be
  // taken.
  private final List<Object> waiting = new ArrayList<>();
  private boolean ending;
  private boolean ended;
  private boolean closed;
  private long lastHandedUs = StreamNotification.NO_TIME_US;
  private long eventsIn;
  private long eventsOut;
  private long eventsLost;
  private int packetsWaiting;
  private int mostWaiting;
  private long readingBytes;
  private int readingsWaiting;
  private long readingsLost;

  /**
   * An empty buffer.
   *
   * @param geometry the sensor of the stream
   * @param packets how many packets there are, at least 2
   * @param capacity events that each holds; larger packets are cut, at least 1
   * @param policy what happens when all are full
   * @param place who loses events then, in words for a person, for {@link DataLost#place()}
   */
  public LiveBuffer(
      SensorGeometry geometry, int packets, int capacity, OverflowPolicy policy, String place) {
    this(geometry, packets, capacity, policy, place, false);
  }

  private LiveBuffer(
      SensorGeometry geometry,
      int packets,
      int capacity,
      OverflowPolicy policy,
      String place,
      boolean gathering) {
    if (packets < 2 || capacity < 1) {
      throw new IllegalArgumentException(
          "a buffer needs 2 packets of 1 event or more, not " + packets + " of " + capacity);
    }
    this.geometry = Objects.requireNonNull(geometry, "geometry");
    this.capacity = capacity;
    this.policy = Objects.requireNonNull(policy, "policy");
    this.place = Objects.requireNonNull(place, "place");
    this.gathering = gathering;
    for (int i = 0; i < packets; i++) {
      free.add(new EventPacket(capacity));
    }
  }

  /**
   * An empty buffer that puts small packets together while they wait, so that it holds as many
   * events however they come. For a consumer to whom borders of packets mean nothing.
   *
   * @param geometry the sensor of the stream
   * @param packets how many packets there are, at least 2
   * @param capacity events that each holds; larger packets are cut, at least 1
   * @param policy what happens when all are full
   * @param place who loses events then, in words for a person, for {@link DataLost#place()}
   * @return a buffer
   */
  public static LiveBuffer gathering(
      SensorGeometry geometry, int packets, int capacity, OverflowPolicy policy, String place) {
    return new LiveBuffer(geometry, packets, capacity, policy, place, true);
  }

  // ---- The producer's side

  /**
   * Puts a copy of the packet in. Under {@link OverflowPolicy#BLOCK} a thread that is interrupted
   * while it waits stays interrupted, and the events are counted as lost.
   *
   * @param packet borrowed and not changed
   */
  @Override
  public void packet(EventPacket packet) {
    int from = 0;
    while (from < packet.size()) {
      lock.lock();
      try {
        EventPacket last = gathering ? lastWaiting() : null;
        int room = last == null ? 0 : capacity - last.size();
        int to = Math.min(packet.size(), from + (room > 0 ? room : capacity));
        eventsIn += to - from;
        if (room > 0) {
          last.append(packet, from, to);
        } else {
          putCopy(packet, from, to);
        }
        from = to;
      } finally {
        lock.unlock();
      }
    }
  }

  private EventPacket lastWaiting() {
    int last = waiting.size() - 1;
    return last >= 0 && waiting.get(last) instanceof EventPacket packet ? packet : null;
  }

  private void putCopy(EventPacket packet, int from, int to) {
    EventPacket copy = room();
    if (copy == null) {
      lose(waiting.size(), to - from);
      return;
    }
    copy.clear();
    copy.append(packet, from, to);
    waiting.add(copy);
    packetsWaiting++;
    mostWaiting = Math.max(mostWaiting, packetsWaiting);
    changed.signalAll();
  }

  /** A packet to fill, or null if the events are to be dropped. */
  private EventPacket room() {
    if (policy == OverflowPolicy.BLOCK) {
      try {
        while (free.isEmpty() && !closed && !ending) {
          changed.await();
        }
      } catch (InterruptedException interrupted) {
        Thread.currentThread().interrupt();
        return null;
      }
    }
    if (closed || ending) {
      return null;
    }
    if (free.isEmpty() && policy == OverflowPolicy.DROP_OLDEST) {
      dropOldest();
    }
    return free.poll();
  }

  private void dropOldest() {
    for (int i = 0; i < waiting.size(); i++) {
      if (waiting.get(i) instanceof EventPacket oldest) {
        waiting.remove(i);
        packetsWaiting--;
        free.add(oldest);
        lose(i, oldest.size());
        return;
      }
    }
  }

  /** Notes that events are missing before what stands at an index. */
  private void lose(int index, int events) {
    eventsLost += events;
    if (closed || ending) {
      return;
    }
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

  /**
   * Puts a reading in. Readings that wait are bounded too: beyond 32 MiB of them {@link
   * OverflowPolicy#BLOCK} waits, and the other policies drop the newest and count it.
   *
   * @param reading immutable
   */
  @Override
  public void reading(SensorReading reading) {
    lock.lock();
    try {
      while (policy == OverflowPolicy.BLOCK && !hasRoomForReading() && !closed && !ending) {
        changed.await();
      }
      if (closed || ending || !hasRoomForReading()) {
        readingsLost++;
        return;
      }
      readingsWaiting++;
      readingBytes += bytes(reading);
      waiting.add(reading);
      changed.signalAll();
    } catch (InterruptedException interrupted) {
      Thread.currentThread().interrupt();
      readingsLost++;
    } finally {
      lock.unlock();
    }
  }

  private boolean hasRoomForReading() {
    return readingsWaiting == 0 || readingBytes < MAX_READING_BYTES;
  }

  private static long bytes(SensorReading reading) {
    return BYTES_PER_READING + (reading instanceof Frame frame ? frame.rows().capacity() : 0);
  }

  @Override
  public void notified(StreamNotification notification) {
    lock.lock();
    try {
      if (closed || ending) {
        return;
      }
      ending = notification instanceof EndOfStream;
      int last = waiting.size() - 1;
      if (notification instanceof Reset next
          && last >= 0
          && waiting.get(last) instanceof Reset before) {
        waiting.set(last, new Reset(next.cause(), before.lastUs(), next.nextUs()));
      } else {
        waiting.add(notification);
      }
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  // ---- The consumer's side

  @Override
  public SensorGeometry geometry() {
    return geometry;
  }

  /**
   * Hands over the next thing of the stream; waits for it.
   *
   * @param handler takes it
   * @return false after the end of the stream, or once closed
   * @throws InterruptedIOException if the thread is interrupted
   */
  @Override
  public boolean next(StreamHandler handler) throws InterruptedIOException {
    Object next = take();
    if (next instanceof EventPacket packet) {
      int events = packet.size();
      try {
        handler.packet(packet);
      } finally {
        giveBack(packet, events);
      }
    } else if (next instanceof SensorReading reading) {
      handler.reading(reading);
    } else if (next != null) {
      handler.notified((StreamNotification) next);
    }
    return next != null;
  }

  /**
   * Waits for the next thing of the stream without taking it.
   *
   * @param nanos at most so long
   * @return true if {@link #next} would not wait now
   * @throws InterruptedIOException if the thread is interrupted
   */
  public boolean await(long nanos) throws InterruptedIOException {
    lock.lock();
    try {
      long left = nanos;
      while (!closed && !ended && !somethingToTake() && left > 0) {
        left = changed.awaitNanos(left);
      }
      return closed || ended || somethingToTake();
    } catch (InterruptedException interrupted) {
      throw interrupted();
    } finally {
      lock.unlock();
    }
  }

  private InterruptedIOException interrupted() {
    Thread.currentThread().interrupt();
    return new InterruptedIOException("interrupted while waiting for " + place);
  }

  /** A packet, a reading, a notification, or null at the end. */
  private Object take() throws InterruptedIOException {
    lock.lock();
    try {
      while (!closed && !ended && !somethingToTake()) {
        changed.await();
      }
      if (closed || ended) {
        return null;
      }
      Object next = waiting.remove(0);
      if (next instanceof EventPacket packet) {
        packetsWaiting--;
        lastHandedUs = packet.lastTimeUs();
        return packet;
      }
      if (next instanceof Gap gap) {
        long toUs =
            waiting.get(0) instanceof EventPacket packet
                ? packet.firstTimeUs()
                : StreamNotification.NO_TIME_US;
        return new DataLost(-1, gap.events, lastHandedUs, toUs, place);
      }
      if (next instanceof SensorReading reading) {
        readingsWaiting--;
        readingBytes -= bytes(reading);
        changed.signalAll();
        return reading;
      }
      StreamNotification notification = (StreamNotification) next;
      if (notification.endsContinuity()) {
        lastHandedUs = StreamNotification.NO_TIME_US;
      }
      ended = notification instanceof EndOfStream;
      return notification;
    } catch (InterruptedException interrupted) {
      throw interrupted();
    } finally {
      lock.unlock();
    }
  }

  /** A gap waits for what comes after it, which may widen it and tells where it ends. */
  private boolean somethingToTake() {
    return waiting.size() > 1 || (!waiting.isEmpty() && !(waiting.get(0) instanceof Gap));
  }

  private void giveBack(EventPacket packet, int events) {
    lock.lock();
    try {
      eventsOut += events;
      free.add(packet);
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  /** Ends the consumer's side: what waits, and whatever still comes, is counted as lost. */
  @Override
  public void close() {
    lock.lock();
    try {
      if (!closed) {
        closed = true;
        for (Object item : waiting) {
          eventsLost += item instanceof EventPacket packet ? packet.size() : 0;
        }
        readingsLost += readingsWaiting;
        readingsWaiting = 0;
        readingBytes = 0;
        waiting.clear();
        packetsWaiting = 0;
        changed.signalAll();
      }
    } finally {
      lock.unlock();
    }
  }

  // ---- Counts

  /**
   * What has become of the events.
   *
   * @param in events that the producer put in
   * @param out events that the consumer has dealt with
   * @param lost events that were dropped
   * @param waitingPackets packets that wait for the consumer
   * @param mostWaitingPackets the most that ever waited
   */
  public record Counts(long in, long out, long lost, int waitingPackets, int mostWaitingPackets) {}

  /**
   * Frames, inertial samples and triggers that were dropped.
   *
   * @return a count since the buffer was made
   */
  public long readingsLost() {
    lock.lock();
    try {
      return readingsLost;
    } finally {
      lock.unlock();
    }
  }

  /**
   * Reads the counts: in = out + lost while no packet waits or is in the consumer's hands.
   *
   * @return all of one moment
   */
  public Counts counts() {
    lock.lock();
    try {
      return new Counts(eventsIn, eventsOut, eventsLost, packetsWaiting, mostWaiting);
    } finally {
      lock.unlock();
    }
  }
}
