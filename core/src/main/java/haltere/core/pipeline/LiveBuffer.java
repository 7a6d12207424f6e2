package haltere.core.pipeline;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.stream.DataLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.EventSource;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.InterruptedIOException;
import java.util.ArrayDeque;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/**
 * Passes one stream from the thread that creates it to the thread that processes it. The number of
 * waiting events is bounded; beyond it, the {@link OverflowPolicy} decides. Dropped events are
 * counted, and one {@link DataLost} marks their position in the stream. Notifications are never
 * dropped; a reset directly after a reset replaces it.
 *
 * <p>Thread rule: one producer uses it as a {@link StreamHandler}, one consumer as an {@link
 * EventSource}; the counts may be read from any thread.
 *
 * @since 0.1
 */
public final class LiveBuffer implements StreamHandler, EventSource {
  private final SensorGeometry geometry;
  private final int maxEvents;
  private final int maxPackets;
  private final int packetEvents;
  private final OverflowPolicy policy;
  private final String place;
  private final boolean coalescing;
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed = lock.newCondition();
  private final int pooledPackets;
  private final ArrayDeque<EventPacket> free = new ArrayDeque<>();

  /** Packets of full size, which are reused; further small packets are created. */
  private final Set<EventPacket> pooled = Collections.newSetFromMap(new IdentityHashMap<>());

  private final LiveQueue waiting;

  /** Whether the consumer holds a packet. */
  private boolean held;

  private boolean ending;
  private boolean ended;
  private boolean closed;
  private long eventsIn;
  private long eventsOut;
  private long eventsLost;
  private long samplesLost;

  /**
   * An empty buffer.
   *
   * @param geometry the sensor of the stream
   * @param maxEvents how many events may wait
   * @param packetEvents larger packets are cut, 1 to {@code maxEvents}
   * @param policy what happens when as many wait
   * @param place who loses events then, in words for users, for {@link DataLost#place()}
   */
  public LiveBuffer(
      SensorGeometry geometry,
      int maxEvents,
      int packetEvents,
      OverflowPolicy policy,
      String place) {
    this(geometry, maxEvents, Integer.MAX_VALUE, packetEvents, policy, place, false);
  }

  private LiveBuffer(
      SensorGeometry geometry,
      int maxEvents,
      int maxPackets,
      int packetEvents,
      OverflowPolicy policy,
      String place,
      boolean coalescing) {
    if (packetEvents < 1 || maxEvents < packetEvents) {
      throw new IllegalArgumentException(
          "a buffer needs room for a packet of 1 event or more, not "
              + maxEvents
              + " for one of "
              + packetEvents);
    }
    this.geometry = Objects.requireNonNull(geometry, "geometry");
    this.maxEvents = maxEvents;
    this.maxPackets = maxPackets;
    this.packetEvents = packetEvents;
    this.policy = Objects.requireNonNull(policy, "policy");
    this.place = Objects.requireNonNull(place, "place");
    this.coalescing = coalescing;
    pooledPackets = maxEvents / packetEvents + 1;
    waiting = new LiveQueue(place);
  }

  /**
   * An empty buffer that joins small packets while they wait. For a consumer that does not depend
   * on packet borders.
   *
   * @param geometry the sensor of the stream
   * @param maxEvents how many events may wait
   * @param packetEvents larger packets are cut, 1 to {@code maxEvents}
   * @param policy what happens when as many wait
   * @param place who loses events then, in words for users, for {@link DataLost#place()}
   * @return a buffer
   */
  public static LiveBuffer coalescing(
      SensorGeometry geometry,
      int maxEvents,
      int packetEvents,
      OverflowPolicy policy,
      String place) {
    return new LiveBuffer(
        geometry, maxEvents, Integer.MAX_VALUE, packetEvents, policy, place, true);
  }

  /**
   * An empty buffer for the transfers of a device, which has a fixed number of them however many
   * events are in each.
   *
   * @param geometry the sensor of the stream
   * @param packets maximum number that may wait, including one held by the consumer, at least 2
   * @param packetEvents larger packets are cut, at least 1
   * @param policy what happens when as many wait
   * @param place who loses events then, in words for users, for {@link DataLost#place()}
   * @return a buffer
   */
  public static LiveBuffer ofPackets(
      SensorGeometry geometry, int packets, int packetEvents, OverflowPolicy policy, String place) {
    return new LiveBuffer(
        geometry, packets * packetEvents, packets, packetEvents, policy, place, false);
  }

  // ---- The producer's side

  /**
   * Adds a copy of the packet. Under {@link OverflowPolicy#BLOCK} a thread that is interrupted
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
        EventPacket last = coalescing ? waiting.lastPacket() : null;
        int left = last == null ? 0 : packetEvents - last.size();
        int to = Math.min(packet.size(), from + (left > 0 ? left : packetEvents));
        int taken = admitted(to - from);
        if (taken > 0) {
          to = from + taken;
          put(packet, from, to);
        } else {
          lose(to - from);
        }
        eventsIn += to - from;
        from = to;
      } finally {
        lock.unlock();
      }
    }
  }

  private void put(EventPacket packet, int from, int to) {
    EventPacket last = coalescing ? waiting.lastPacket() : null;
    if (last != null && last.size() + to - from <= packetEvents) {
      last.append(packet, from, to);
      waiting.lastGrew(to - from);
      return;
    }
    EventPacket copy = free.poll();
    if (copy == null && pooled.size() < pooledPackets) {
      copy = new EventPacket(packetEvents);
      pooled.add(copy);
    } else if (copy == null) {
      copy = new EventPacket(to - from);
    }
    copy.clear();
    copy.append(packet, from, to);
    waiting.add(copy);
    changed.signalAll();
  }

  /** Number of further events that may wait. */
  private int room() {
    int packets = waiting.packets() + (held ? 1 : 0);
    return packets >= maxPackets ? 0 : maxEvents - waiting.events();
  }

  /** Reserves space by the policy; returns the number of accepted events. */
  private int admitted(int events) {
    if (policy == OverflowPolicy.BLOCK) {
      try {
        while (room() < events && !closed && !ending) {
          changed.await();
        }
      } catch (InterruptedException interrupted) {
        Thread.currentThread().interrupt();
        return 0;
      }
    }
    if (closed || ending) {
      return 0;
    }
    while (policy == OverflowPolicy.DROP_OLDEST && room() < events && waiting.packets() > 0) {
      EventPacket oldest = waiting.dropOldest();
      eventsLost += oldest.size();
      free(oldest);
    }
    return Math.min(events, room());
  }

  private void free(EventPacket packet) {
    if (pooled.contains(packet)) {
      free.add(packet);
    }
  }

  private void lose(int events) {
    eventsLost += events;
    if (!closed && !ending) {
      waiting.addGap(events);
    }
  }

  /**
   * Adds a sample. Waiting samples are bounded too: beyond 32 MiB of them {@link
   * OverflowPolicy#BLOCK} waits, and the other policies drop the newest and count it.
   *
   * @param sample immutable
   */
  @Override
  public void sample(SensorSample sample) {
    lock.lock();
    try {
      while (policy == OverflowPolicy.BLOCK && !waiting.hasRoomForSample() && !closed && !ending) {
        changed.await();
      }
      if (closed || ending || !waiting.hasRoomForSample()) {
        samplesLost++;
        return;
      }
      waiting.add(sample);
      changed.signalAll();
    } catch (InterruptedException interrupted) {
      Thread.currentThread().interrupt();
      samplesLost++;
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
   * Passes on the next packet, notification or sample; waits for it.
   *
   * @param handler receives it
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
        recycle(packet, events);
      }
    } else if (next instanceof SensorSample sample) {
      handler.sample(sample);
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

  /** A packet, a sample, a notification, or null at the end. */
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
      held = next instanceof EventPacket;
      changed.signalAll();
      ended = next instanceof EndOfStream;
      return next;
    } catch (InterruptedException interrupted) {
      throw interrupted();
    } finally {
      lock.unlock();
    }
  }

  private void recycle(EventPacket packet, int events) {
    lock.lock();
    try {
      eventsOut += events;
      held = false;
      free(packet);
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  /** Ends the consumer's side: waiting and later events are counted as lost. */
  @Override
  public void close() {
    lock.lock();
    try {
      if (!closed) {
        closed = true;
        samplesLost += waiting.samples();
        eventsLost += waiting.clear();
        changed.signalAll();
      }
    } finally {
      lock.unlock();
    }
  }

  // ---- Counts

  /**
   * Counts of events.
   *
   * @param in events from the producer
   * @param out events processed by the consumer
   * @param lost events that were dropped
   * @param waitingPackets packets that wait for the consumer
   * @param maxWaitingPackets maximum of {@code waitingPackets} so far
   */
  public record Counts(long in, long out, long lost, int waitingPackets, int maxWaitingPackets) {}

  /**
   * Frames, inertial samples and triggers that were dropped.
   *
   * @return a count since the buffer was created
   */
  public long samplesLost() {
    lock.lock();
    try {
      return samplesLost;
    } finally {
      lock.unlock();
    }
  }

  /**
   * Reads the counts: in = out + lost while no packet waits or is held by the consumer.
   *
   * @return a consistent snapshot
   */
  public Counts counts() {
    lock.lock();
    try {
      return new Counts(eventsIn, eventsOut, eventsLost, waiting.packets(), waiting.peakPackets());
    } finally {
      lock.unlock();
    }
  }
}
