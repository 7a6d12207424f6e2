package haltere.device.usb;

import haltere.core.camera.CameraProblem;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/**
 * Keeps a number of transfers active: time-stamps each completed one with {@link System#nanoTime},
 * passes on its buffer, and restarts it with another one. Does nothing else within a listener.
 *
 * <p>A transfer is started in one place only, under the lock and while the ring is {@link
 * RingState#RUNNING}; the ring leaves this state, and cancels active transfers, under the same
 * lock. So no transfer can start after all were cancelled, and transfers are freed only once each
 * has ended.
 *
 * <p>Thread rule: all methods may be called from any thread that is not within a listener.
 */
public final class TransferRing {
  private enum RingState {
    RUNNING,
    RECOVERING,
    GONE,
    STOPPED
  }

  private static final long STOP_NANOS = TimeUnit.SECONDS.toNanos(2);
  private static final long LAST_ARRIVALS_NANOS = TimeUnit.MILLISECONDS.toNanos(500);
  private static final long RECOVERY_NANOS = TimeUnit.MILLISECONDS.toNanos(500);

  /** Maximum number of successive failed transfers, or recoveries without effect. */
  private static final int MAX_FAILURES = 16;

  private final UsbTransport transport;
  private final int endpoint;
  private final ReceivedBuffers buffers;
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition ended = lock.newCondition();
  private final List<Slot> slots = new ArrayList<>();
  private RingState state = RingState.STOPPED;
  private int underWay;
  private int failures;

  /** A transfer and its current buffer. */
  private final class Slot implements TransferListener {
    private final BulkTransfer transfer;
    private Received received = buffers.spare();
    private boolean busy;

    Slot() {
      transfer = transport.prepare(endpoint, this);
    }

    @Override
    public void ended(TransferEnd end, int bytes) {
      long nanos = System.nanoTime();
      lock.lock();
      try {
        busy = false;
        underWay--;
        boolean whole = end == TransferEnd.COMPLETED;
        if (whole || bytes > 0 || state == RingState.RUNNING) {
          received.filled(end, bytes, nanos);
          received = buffers.arrived(received);
        }
        if (state == RingState.RUNNING) {
          resubmit(this, end);
        }
        if (underWay == 0) {
          ended.signalAll();
          if (state == RingState.GONE) {
            buffers.endOfDeviceWithin(0);
          }
        }
      } finally {
        lock.unlock();
      }
    }
  }

  /**
   * A ring that is not started.
   *
   * @param transport the device
   * @param endpoint address of a bulk endpoint, 0x80 or more
   * @param transfers number of simultaneous transfers
   * @param buffers receive the data; created for this number of transfers
   */
  public TransferRing(
      UsbTransport transport, int endpoint, int transfers, ReceivedBuffers buffers) {
    this.transport = transport;
    this.endpoint = endpoint;
    this.buffers = buffers;
    for (int i = 0; i < transfers; i++) {
      slots.add(new Slot());
    }
  }

  /** Starts all transfers; the buffers are notified if the device is lost already. */
  public void start() {
    lock.lock();
    try {
      state = RingState.RUNNING;
      startAll();
    } finally {
      lock.unlock();
    }
  }

  private void startAll() {
    for (Slot slot : slots) {
      start(slot);
    }
  }

  /** The only place where a transfer starts. The caller holds the lock. */
  private void start(Slot slot) {
    if (state != RingState.RUNNING || slot.busy) {
      return;
    }
    if (slot.transfer.submit(slot.received.buffer())) {
      slot.busy = true;
      underWay++;
    } else {
      abandonDevice();
    }
  }

  private void resubmit(Slot slot, TransferEnd end) {
    switch (end) {
      case COMPLETED -> {
        failures = 0;
        start(slot);
      }
      case STALLED -> {
        // the consumer finds the failure and starts the recovery; a listener must not wait
      }
      case OVERFLOW, FAILED -> {
        if (++failures > MAX_FAILURES) {
          abandonDevice();
        } else {
          start(slot);
        }
      }
      case CANCELLED, GONE -> abandonDevice();
    }
  }

  /** Gives up a lost device; arrived data are still being processed by the bus. */
  private void abandonDevice() {
    state = RingState.GONE;
    buffers.endOfDeviceWithin(LAST_ARRIVALS_NANOS);
  }

  private void cancelAll() {
    for (Slot slot : slots) {
      if (slot.busy) {
        slot.transfer.cancel();
      }
    }
  }

  /**
   * Clears a halt of the endpoint and restarts; does nothing without a halt. A device that cannot
   * be recovered is lost.
   */
  public void recover() {
    lock.lock();
    try {
      if (state != RingState.RUNNING || underWay == slots.size()) {
        return;
      }
      state = RingState.RECOVERING;
      cancelAll();
      if (!awaitAllEnded(RECOVERY_NANOS) || ++failures > MAX_FAILURES) {
        abandonDevice();
        return;
      }
    } finally {
      lock.unlock();
    }
    boolean lifted = clearHalt();
    lock.lock();
    try {
      if (state == RingState.RECOVERING) {
        if (lifted) {
          state = RingState.RUNNING;
          startAll();
        } else {
          abandonDevice();
        }
      }
    } finally {
      lock.unlock();
    }
  }

  private boolean clearHalt() {
    try {
      transport.clearHalt(endpoint);
      return true;
    } catch (CameraProblem ignored) {
      return false;
    }
  }

  /**
   * Stops for good: cancels all transfers, waits until each has ended, and frees them.
   *
   * @return false if one does not end within seconds; then nothing is freed, since libusb may still
   *     write to it, and the transport must stay open
   */
  public boolean stop() {
    lock.lock();
    try {
      state = RingState.STOPPED;
      cancelAll();
      if (!awaitAllEnded(STOP_NANOS)) {
        return false;
      }
    } finally {
      lock.unlock();
    }
    transport.free(slots.stream().map(slot -> slot.transfer).toList());
    slots.clear();
    return true;
  }

  /** Waits for the end of all transfers and releases the lock meanwhile; not interruptible. */
  private boolean awaitAllEnded(long nanos) {
    long end = System.nanoTime() + nanos;
    boolean interrupted = false;
    while (underWay > 0) {
      long left = end - System.nanoTime();
      if (left <= 0) {
        break;
      }
      try {
        ended.awaitNanos(left);
      } catch (InterruptedException ignored) {
        interrupted = true;
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
    return underWay == 0;
  }
}
