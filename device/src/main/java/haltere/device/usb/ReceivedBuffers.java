package haltere.device.usb;

import haltere.core.camera.CameraOptions.WhenFull;
import haltere.device.protocol.DroppedWords;
import java.io.InterruptedIOException;
import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Supplier;

/**
 * Queue of received buffers for the consumer. All buffers are allocated at the start; if too many
 * wait, whole transfers are dropped, and their summary stays in the queue.
 *
 * <p>Thread rule: one thread at a time handles events of the bus ({@link #arrived}, {@link
 * #endOfDeviceWithin}); it may be the consumer's, of which there is one ({@link #take}, {@link
 * #release}). The rest from any thread.
 */
public final class ReceivedBuffers {
  private static final int ALIGNMENT = 64;
  private static final long MAX_BYTES = 1L << 30;

  /** Longest wait of the oldest buffer if the newest data are preferred. */
  private static final long UP_TO_DATE_NANOS = TimeUnit.MILLISECONDS.toNanos(500);

  private final WhenFull whenFull;
  private final ReentrantLock lock = new ReentrantLock();
  private final ArrivalWait change;
  private final ArrayDeque<Received> free = new ArrayDeque<>();
  private final ArrayDeque<Received> waiting = new ArrayDeque<>();

  /** Words dropped after all waiting buffers. */
  private DroppedWords droppedLast;

  /** Dropped words that are no longer needed. */
  private final DroppedWords abandoned;

  private boolean isLeaving;
  private long lostNanos;
  private boolean lost;
  private boolean ended;
  private long transfers;
  private long bytes;
  private long lostTransfers;
  private long lostEvents;
  private long brokenTransfers;
  private int maxWaiting;

  /**
   * Empty buffers.
   *
   * @param transfers number that the device may fill at a time, at least 1
   * @param waiting maximum number waiting for the consumer, at least 1
   * @param bufferBytes size of each
   * @param whenFull which are dropped if more would wait; if the oldest, also those that have
   *     waited for half a second when a newer one arrives
   * @param notes creates empty summaries of dropped words
   * @param work of the bus, for a waiting consumer
   * @throws IllegalArgumentException if there are none, or if all would need more than 1 GiB
   */
  public ReceivedBuffers(
      int transfers,
      int waiting,
      int bufferBytes,
      WhenFull whenFull,
      Supplier<DroppedWords> notes,
      BusWork work) {
    change = new ArrivalWait(lock, work);
    if (transfers < 1 || waiting < 1 || bufferBytes < 1) {
      throw new IllegalArgumentException(
          transfers + " and " + waiting + " buffers of " + bufferBytes + " bytes");
    }
    this.whenFull = Objects.requireNonNull(whenFull, "whenFull");
    droppedLast = notes.get();
    abandoned = notes.get();
    int count = transfers + waiting + 1;
    if ((long) count * (bufferBytes + ALIGNMENT) > MAX_BYTES) {
      throw new IllegalArgumentException(
          count
              + " buffers of "
              + bufferBytes
              + " bytes would need more than "
              + (MAX_BYTES >> 20)
              + " MiB");
    }
    int stride = (bufferBytes + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    ByteBuffer all = ByteBuffer.allocateDirect(Math.multiplyExact(count, stride));
    for (int i = 0; i < count; i++) {
      free.add(new Received(all.slice(i * stride, bufferBytes), notes.get()));
    }
  }

  // ---- The side of the bus

  /** A buffer for a transfer, at the start. */
  Received spare() {
    lock.lock();
    try {
      return free.remove();
    } finally {
      lock.unlock();
    }
  }

  /**
   * Queues the buffer of an ended transfer; never waits for the consumer.
   *
   * @param received filled
   * @return the buffer for the next transfer, which may be the same
   */
  Received arrived(Received received) {
    lock.lock();
    try {
      transfers++;
      bytes += received.length();
      boolean whole = received.end() == TransferEnd.COMPLETED;
      brokenTransfers += whole ? 0 : 1;
      if (ended || lost) {
        abandon(received);
        return received;
      }
      if (whole && received.length() == 0) {
        return received;
      }
      if (whenFull == WhenFull.DROP_OLDEST) {
        dropOutdated(received.arrivedNanos());
      }
      Received next = free.poll();
      if (next == null && whenFull == WhenFull.DROP_OLDEST) {
        next = dropOldest();
      }
      if (next == null) {
        dropAfterAll(received);
        return received;
      }
      if (!droppedLast.isEmpty()) {
        droppedLast = received.swapBefore(droppedLast);
      }
      waiting.add(received);
      maxWaiting = Math.max(maxWaiting, waiting.size());
      change.changed();
      return next;
    } finally {
      lock.unlock();
    }
  }

  private void dropAfterAll(Received received) {
    long before = droppedLast.events();
    note(droppedLast, received);
    lostTransfers++;
    lostEvents += droppedLast.events() - before;
  }

  private void dropOutdated(long nanos) {
    while (!waiting.isEmpty() && nanos - waiting.peek().arrivedNanos() > UP_TO_DATE_NANOS) {
      free.add(dropOldest());
    }
  }

  private Received dropOldest() {
    Received oldest = waiting.poll();
    if (oldest == null) {
      return null;
    }
    DroppedWords dropped = oldest.before();
    long before = dropped.events();
    note(dropped, oldest);
    lostTransfers++;
    lostEvents += dropped.events() - before;
    Received head = waiting.peek();
    if (head == null) {
      dropped.add(droppedLast);
      droppedLast = oldest.swapBefore(droppedLast);
    } else {
      dropped.add(head.before());
      oldest.swapBefore(head.swapBefore(dropped));
    }
    oldest.before().clear();
    return oldest;
  }

  private static void note(DroppedWords note, Received received) {
    note.add(received.bytes());
    if (received.end() != TransferEnd.COMPLETED && received.end() != TransferEnd.GONE) {
      note.addUnknown();
    }
  }

  /** Counts a buffer that the consumer will not receive. */
  private void abandon(Received received) {
    if (received.length() > 0) {
      abandoned.clear();
      abandoned.add(received.bytes());
      lostTransfers++;
      lostEvents += abandoned.events();
    }
  }

  /** Sets the end of data after a time, 0 for at once; the shortest time counts. */
  void endOfDeviceWithin(long nanos) {
    lock.lock();
    try {
      long at = System.nanoTime() + nanos;
      if (!isLeaving || at - lostNanos < 0) {
        lostNanos = at;
      }
      isLeaving = true;
      lost |= nanos == 0;
      change.changed();
    } finally {
      lock.unlock();
    }
  }

  // ---- The consumer's side

  /**
   * Waits for the next buffer.
   *
   * @param nanos longest wait
   * @return a buffer to {@link #release}, or null after a timeout or at the end
   * @throws InterruptedIOException if the thread is interrupted
   */
  public Received take(long nanos) throws InterruptedIOException {
    lock.lock();
    try {
      long left = nanos;
      if (!waiting.isEmpty()) {
        change.look();
      }
      while (waiting.isEmpty() && !ended && !lost && left > 0) {
        left -= awaitChange(left);
      }
      return waiting.poll();
    } catch (InterruptedException interrupted) {
      Thread.currentThread().interrupt();
      throw new InterruptedIOException("interrupted while waiting for a camera");
    } finally {
      lock.unlock();
    }
  }

  /** Waits for a change, up to a time limit or the end of the device; returns the elapsed time. */
  private long awaitChange(long nanos) throws InterruptedException {
    long start = System.nanoTime();
    change.await(isLeaving ? Math.min(nanos, lostNanos - start) : nanos);
    long now = System.nanoTime();
    lost |= isLeaving && now - lostNanos >= 0;
    return now - start;
  }

  /**
   * Returns a buffer.
   *
   * @param received a buffer from {@link #take}
   */
  public void release(Received received) {
    lock.lock();
    try {
      received.before().clear();
      free.add(received);
    } finally {
      lock.unlock();
    }
  }

  /**
   * Whether the device is lost and all earlier data have been taken.
   *
   * @return true if {@link #take} will return null for this reason
   */
  public boolean isAtEndOfDevice() {
    lock.lock();
    try {
      return lost && waiting.isEmpty();
    } finally {
      lock.unlock();
    }
  }

  /**
   * Words dropped after the last taken buffer.
   *
   * @return a summary; only after {@link #isAtEndOfDevice} or {@link #isEnded}
   */
  public DroppedWords droppedLast() {
    return droppedLast;
  }

  /**
   * Whether {@link #end} was called and all earlier data have been taken.
   *
   * @return true if {@link #take} will return null for this reason
   */
  public boolean isEnded() {
    lock.lock();
    try {
      return ended && waiting.isEmpty();
    } finally {
      lock.unlock();
    }
  }

  /**
   * Ends the queue: later data are counted as lost, waiting buffers can be taken, and a waiting
   * consumer wakes up.
   */
  public void end() {
    lock.lock();
    try {
      ended = true;
      change.changed();
    } finally {
      lock.unlock();
    }
    change.interrupt();
  }

  /** Ends the queue, and counts waiting buffers as lost too. */
  public void close() {
    end();
    lock.lock();
    try {
      waiting.forEach(this::abandon);
      waiting.clear();
    } finally {
      lock.unlock();
    }
  }

  /**
   * Counts of received data.
   *
   * @param transfers completed transfers
   * @param bytes in them
   * @param lostTransfers lost transfers
   * @param lostEvents in those
   * @param brokenTransfers failed transfers
   * @param waiting waiting buffers
   * @param maxWaiting largest number of waiting buffers
   */
  public record BufferCounts(
      long transfers,
      long bytes,
      long lostTransfers,
      long lostEvents,
      long brokenTransfers,
      int waiting,
      int maxWaiting) {
    /** Counts before the first data. */
    public static final BufferCounts NONE = new BufferCounts(0, 0, 0, 0, 0, 0, 0);
  }

  /**
   * Reads the counts.
   *
   * @return a consistent snapshot
   */
  public BufferCounts counts() {
    lock.lock();
    try {
      return new BufferCounts(
          transfers, bytes, lostTransfers, lostEvents, brokenTransfers, waiting.size(), maxWaiting);
    } finally {
      lock.unlock();
    }
  }
}
