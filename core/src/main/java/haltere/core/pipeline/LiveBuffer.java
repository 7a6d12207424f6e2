package haltere.core.pipeline;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorReading;
import haltere.core.stream.DataLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.EventSource;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.InterruptedIOException;
import java.util.ArrayDeque;
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
  private final SensorGeometry geometry;
  private final int capacity;
  private final OverflowPolicy policy;
  private final String place;
  private final boolean gathering;
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed = lock.newCondition();
  private final ArrayDeque<EventPacket> free = new ArrayDeque<>();
  private final LiveQueue waiting;
  private boolean ending;
  private boolean ended;
  private boolean closed;
  private long eventsIn;
  private long eventsOut;
  private long eventsLost;
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
    waiting = new LiveQueue(place);
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
        EventPacket last = gathering ? waiting.lastPacket() : null;
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

  private void putCopy(EventPacket packet, int from, int to) {
    EventPacket copy = room();
    if (copy == null) {
      lose(to - from);
      return;
    }
    copy.clear();
    copy.append(packet, from, to);
    waiting.add(copy);
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
    EventPacket oldest = waiting.dropOldest();
    if (oldest != null) {
      eventsLost += oldest.size();
      free.add(oldest);
    }
  }

  private void lose(int events) {
    eventsLost += events;
    if (!closed && !ending) {
      waiting.addGap(events);
    }
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
      while (policy == OverflowPolicy.BLOCK && !waiting.hasRoomForReading() && !closed && !ending) {
        changed.await();
      }
      if (closed || ending || !waiting.hasRoomForReading()) {
        readingsLost++;
        return;
      }
      waiting.add(reading);
      changed.signalAll();
    } catch (InterruptedException interrupted) {
      Thread.currentThread().interrupt();
      readingsLost++;
    } finally {
      lock.unlock();
    }
  }

  @Override
  public void notified(StreamNotification notification) {
    lock.lock();
    try {
      if (closed || ending) {
        return;
      }
      ending = notification instanceof EndOfStream;
      waiting.add(notification);
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
   * Hands over the next packet, notification or sample; waits for it.
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
   * Waits for the next packet, notification or sample without taking it.
   *
   * @param nanos at most so long
   * @return true if {@link #next} would not wait now
   * @throws InterruptedIOException if the thread is interrupted
   */
  public boolean await(long nanos) throws InterruptedIOException {
    lock.lock();
    try {
      long left = nanos;
      while (!closed && !ended && !waiting.hasNext() && left > 0) {
        left = changed.awaitNanos(left);
      }
      return closed || ended || waiting.hasNext();
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
      while (!closed && !ended && !waiting.hasNext()) {
        changed.await();
      }
      if (closed || ended) {
        return null;
      }
      Object next = waiting.take();
      if (next instanceof SensorReading) {
        changed.signalAll();
      }
      ended = next instanceof EndOfStream;
      return next;
    } catch (InterruptedException interrupted) {
      throw interrupted();
    } finally {
      lock.unlock();
    }
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
        readingsLost += waiting.readings();
        eventsLost += waiting.clear();
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
      return new Counts(eventsIn, eventsOut, eventsLost, waiting.packets(), waiting.mostPackets());
    } finally {
      lock.unlock();
    }
  }
}
