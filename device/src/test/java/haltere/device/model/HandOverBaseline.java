package haltere.device.model;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.Pipe;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.LongSupplier;

/**
 * What the machine itself takes to hand something over in the way of a camera on emulated USB:
 * bytes by a pipe to a thread that stands for the emulated kernel, from there by a pipe to the
 * consumer's, which then counts for as long as the camera's works.
 */
final class HandOverBaseline {
  private static final int BYTES = 4000;

  private final Pipe toKernel = Pipe.open();
  private final Pipe toConsumer = Pipe.open();
  private final LongSupplier workNanos;
  private volatile LatencyHistogram histogram;

  /**
   * Threads that wait.
   *
   * @param workNanos how long the consumer works
   */
  HandOverBaseline(LongSupplier workNanos) throws IOException {
    this.workNanos = workNanos;
    start("bare-kernel", this::kernel);
    start("bare-consumer", this::consume);
  }

  private interface Body {
    void run() throws IOException;
  }

  private static void start(String name, Body body) {
    Thread thread =
        new Thread(
            () -> {
              try {
                while (true) {
                  body.run();
                }
              } catch (IOException ended) {
                // the end of the measurement
              }
            },
            name);
    thread.setDaemon(true);
    thread.start();
  }

  private final ByteBuffer kernelsBytes = ByteBuffer.allocateDirect(BYTES);
  private final ByteBuffer kernelsTime = ByteBuffer.allocateDirect(Long.BYTES);
  private final ByteBuffer consumersTime = ByteBuffer.allocateDirect(Long.BYTES);

  private void kernel() throws IOException {
    read(toKernel, kernelsBytes);
    Thread.yield(); // as the emulated kernel does
    write(toConsumer, kernelsTime.clear().putLong(0, System.nanoTime()));
  }

  private void consume() throws IOException {
    read(toConsumer, consumersTime);
    long end = System.nanoTime() + workNanos.getAsLong();
    while (System.nanoTime() < end) {
      Thread.onSpinWait();
    }
    histogram.add(System.nanoTime() - consumersTime.getLong(0));
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
