package haltere.device.model;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.Pipe;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.LockSupport;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.LongSupplier;

/**
 * What the machine itself takes to hand something over in the way of a camera on emulated USB:
 * bytes by a pipe to a thread that stands for the emulated kernel, from there by a pipe to one that
 * stands for that of the bus, from there by a lock to the consumer's, which then counts for as long
 * as the camera's works.
 */
final class BareHandOver {
  private static final int BYTES = 4000;

  private final Pipe toKernel = Pipe.open();
  private final Pipe toBus = Pipe.open();
  private final LongSupplier workNanos;
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition arrived = lock.newCondition();
  private long handedOverNanos;
  private volatile LatencyHistogram histogram;

  /**
   * Threads that wait.
   *
   * @param workNanos how long the consumer works
   */
  BareHandOver(LongSupplier workNanos) throws IOException {
    this.workNanos = workNanos;
    start("bare-kernel", this::kernel);
    start("bare-bus", this::bus);
    start("bare-consumer", this::consume);
  }

  private interface Body {
    void run() throws IOException, InterruptedException;
  }

  private static void start(String name, Body body) {
    Thread thread =
        new Thread(
            () -> {
              try {
                while (true) {
                  body.run();
                }
              } catch (IOException | InterruptedException ended) {
                // the end of the measurement
              }
            },
            name);
    thread.setDaemon(true);
    thread.start();
  }

  private final ByteBuffer kernelsBytes = ByteBuffer.allocateDirect(BYTES);
  private final ByteBuffer kernelsTime = ByteBuffer.allocateDirect(Long.BYTES);
  private final ByteBuffer busTime = ByteBuffer.allocateDirect(Long.BYTES);

  private void kernel() throws IOException {
    read(toKernel, kernelsBytes);
    write(toBus, kernelsTime.clear().putLong(0, System.nanoTime()));
  }

  private void bus() throws IOException {
    read(toBus, busTime);
    lock.lock();
    try {
      handedOverNanos = busTime.getLong(0);
      arrived.signalAll();
    } finally {
      lock.unlock();
    }
  }

  private void consume() throws InterruptedException {
    long handedOver;
    lock.lock();
    try {
      while (handedOverNanos == 0) {
        arrived.await();
      }
      handedOver = handedOverNanos;
      handedOverNanos = 0;
    } finally {
      lock.unlock();
    }
    long end = System.nanoTime() + workNanos.getAsLong();
    while (System.nanoTime() < end) {
      Thread.onSpinWait();
    }
    histogram.add(System.nanoTime() - handedOver);
  }

  private static void read(Pipe from, ByteBuffer into) throws IOException {
    into.clear();
    while (into.hasRemaining()) {
      from.source().read(into);
    }
  }

  private static void write(Pipe to, ByteBuffer from) throws IOException {
    while (from.hasRemaining()) {
      to.sink().write(from);
    }
  }

  /**
   * Hands something over each millisecond.
   *
   * @param times how often
   * @param into takes the time from the end of the first pipe to that of the consumer's work
   */
  void run(int times, LatencyHistogram into) throws IOException {
    histogram = into;
    ByteBuffer bytes = ByteBuffer.allocateDirect(BYTES);
    long start = System.nanoTime();
    for (int i = 0; i < times; i++) {
      long due = start + TimeUnit.MILLISECONDS.toNanos(i);
      while (System.nanoTime() < due) {
        LockSupport.parkNanos(due - System.nanoTime());
      }
      write(toKernel, bytes.clear());
    }
  }
}
