package haltere.core.pipeline;

import haltere.core.event.EventPacket;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.TimeUnit;

/**
 * Passes packets between threads: a fixed number of packets circulates, free ones to the producer,
 * filled ones to the consumer. All are allocated at the start, so memory is bounded. The free
 * packet released last is used first, because it is still in the processor caches.
 *
 * <p>Thread rule: one producer ({@link #take}, {@link #poll}, {@link #hand}) and one consumer
 * ({@link #receive}, {@link #tryReceive}, {@link #release}); each owns a packet between getting it
 * and giving it away.
 *
 * @since 0.1
 */
public final class PacketPool {
  /** The first {@link #freeCount} of these are free; also the lock of both. */
  private final EventPacket[] free;

  private int freeCount;
  private final ArrayBlockingQueue<EventPacket> filled;

  /**
   * A pool of free packets.
   *
   * @param packets number of packets, at least 2 so that both sides can have one
   * @param capacity events that each can hold before it grows
   */
  public PacketPool(int packets, int capacity) {
    if (packets < 2) {
      throw new IllegalArgumentException("a pool has at least 2 packets, not " + packets);
    }
    free = new EventPacket[packets];
    filled = new ArrayBlockingQueue<>(packets);
    while (freeCount < packets) {
      free[freeCount++] = new EventPacket(capacity);
    }
  }

  /**
   * Gets a free packet; waits for one.
   *
   * @return an empty packet that the producer owns until {@link #hand}
   * @throws InterruptedException if the thread is interrupted
   */
  public EventPacket take() throws InterruptedException {
    synchronized (free) {
      while (freeCount == 0) {
        free.wait();
      }
      return free[--freeCount];
    }
  }

  /**
   * Gets a free packet if there is one.
   *
   * @return an empty packet, or null
   */
  public EventPacket poll() {
    synchronized (free) {
      return freeCount == 0 ? null : free[--freeCount];
    }
  }

  /**
   * Hands a packet to the consumer; never waits.
   *
   * @param packet one of this pool
   * @throws IllegalStateException if it cannot be one of this pool, which would be full
   */
  public void hand(EventPacket packet) {
    filled.add(packet);
  }

  /**
   * Gets the next filled packet; waits for one.
   *
   * @param nanos at most so long
   * @return a packet that the consumer owns until it releases it, or null if none came
   * @throws InterruptedException if the thread is interrupted
   */
  public EventPacket receive(long nanos) throws InterruptedException {
    return filled.poll(nanos, TimeUnit.NANOSECONDS);
  }

  /**
   * Gets the next filled packet; waits for one.
   *
   * @return a packet that the consumer owns until it releases it
   * @throws InterruptedException if the thread is interrupted
   */
  public EventPacket receive() throws InterruptedException {
    return filled.take();
  }

  /**
   * Gets the next filled packet if there is one.
   *
   * @return a packet, or null
   */
  public EventPacket tryReceive() {
    return filled.poll();
  }

  /**
   * Gives a packet back, empty.
   *
   * @param packet one of this pool
   * @throws IllegalStateException if it cannot be one of this pool, which would be full
   */
  public void release(EventPacket packet) {
    packet.clear();
    synchronized (free) {
      if (freeCount == free.length) {
        throw new IllegalStateException("the pool is full");
      }
      free[freeCount++] = packet;
      free.notify();
    }
  }

  /**
   * Filled packets that wait for the consumer.
   *
   * @return a count
   */
  public int waiting() {
    return filled.size();
  }
}
