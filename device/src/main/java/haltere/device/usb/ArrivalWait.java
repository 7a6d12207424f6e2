package haltere.device.usb;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.IntBuffer;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/**
 * The wait of the consumer for a change: handling events of the bus if possible, else asleep.
 *
 * <p>Thread rule: the lock is held except for {@link #interrupt}.
 */
final class ArrivalWait {
  private final ReentrantLock lock;
  private final Condition changed;
  private final BusWork work;

  /** 1 after a change since the consumer's last check; libusb reads it. */
  private final IntBuffer change =
      ByteBuffer.allocateDirect(Integer.BYTES).order(ByteOrder.nativeOrder()).asIntBuffer();

  ArrivalWait(ReentrantLock lock, BusWork work) {
    this.lock = lock;
    this.work = work;
    changed = lock.newCondition();
  }

  /** Marks a change. Outside of a listener, call {@link #interrupt} afterwards. */
  void changed() {
    change.put(0, 1);
    changed.signalAll();
  }

  /** Wakes a consumer that handles events of the bus; without the lock. */
  void interrupt() {
    work.interrupt();
  }

  /** Handles pending events of the bus. */
  void look() {
    work(0);
  }

  /** Waits for a change or a timeout; releases the lock meanwhile. */
  void await(long nanos) throws InterruptedException {
    if (Thread.interrupted()) {
      throw new InterruptedException();
    }
    if (nanos > 0 && !work(nanos) && change.get(0) == 0) {
      changed.awaitNanos(nanos);
    }
  }

  private boolean work(long nanos) {
    change.put(0, 0);
    lock.unlock();
    try {
      return work.doFor(nanos, change);
    } finally {
      lock.lock();
    }
  }
}
