package haltere.device.model;

import haltere.core.camera.Camera;
import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.DataLost;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.DefaultChain;
import haltere.testing.usb.Dvs128Firmware;
import haltere.testing.usb.EmulatedDevice;
import java.io.IOException;
import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.nio.ByteOrder;
import java.nio.MappedByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/**
 * How long events take from the emulated bus to the end of the default chain: a batch each
 * millisecond, which is one transfer. Second by second this takes turns with {@link
 * HandOverBaseline}, so that what the machine takes itself is known of the same minutes. The
 * camera's clock stands still meanwhile, so that its events are one stream.
 *
 * <p>While Java still compiles, its compilers take a processor for milliseconds at a time; the
 * seconds until that is over are told by themselves. What the emulator leaves on the heap is
 * collected once after them.
 */
final class LatencyMeasurement implements StreamHandler {
  private static final int BATCH_US = 1000;
  private static final int BATCHES = 1000;
  private static final int KEPT = 1 << 16;
  private static final int WARM_UP_BLOCKS = 40;
  private static final int MEAN_OF = 256;
  private static final double[] SHARES = {0.5, 0.9, 0.99, 0.999};

  private final Dvs128Firmware firmware;
  private final EmulatedDevice device;
  private final MappedByteBuffer stamps;
  private final FilterChain chain = DefaultChain.create(new SensorGeometry(128, 128));
  private final LatencyHistogram sinceSent = new LatencyHistogram();
  private final LatencyHistogram sinceHandedOver = new LatencyHistogram();
  private final LatencyHistogram warmingUp = new LatencyHistogram();
  private final LatencyHistogram bare = new LatencyHistogram();
  private final SeenObjects objects = new SeenObjects();
  private final long[] sentNanos = new long[KEPT];
  private final int[] stampOfBatch = new int[KEPT];
  private volatile long firstMeasured = Long.MAX_VALUE;
  private volatile boolean ended;

  /** Running mean of the chain's time for a batch. */
  private volatile long workNanos;

  private volatile long collectedBeforeMs;
  private long losses;
  private long unmatched;

  /**
   * A measurement; the emulator must not have been opened before.
   *
   * @param firmware sends
   * @param device it is in
   * @param folder of the emulated USB
   */
  LatencyMeasurement(Dvs128Firmware firmware, EmulatedDevice device, Path folder)
      throws IOException {
    this.firmware = firmware;
    this.device = device;
    try (FileChannel file =
        FileChannel.open(
            folder.resolve("stamps"),
            StandardOpenOption.CREATE,
            StandardOpenOption.READ,
            StandardOpenOption.WRITE)) {
      stamps = file.map(FileChannel.MapMode.READ_WRITE, 0, (KEPT + 1L) * Long.BYTES);
    }
    stamps.order(ByteOrder.nativeOrder());
  }

  // ---- The sender's side

  /**
   * Sends for some seconds, every other of which is the bare hand-over's.
   *
   * @param seconds beyond those that warm everything up
   */
  private void send(int seconds) throws IOException {
    HandOverBaseline hands = new HandOverBaseline(() -> workNanos);
    LatencyHistogram bareWarmingUp = new LatencyHistogram();
    for (int second = 0; second < seconds + WARM_UP_BLOCKS; second++) {
      boolean measured = second >= WARM_UP_BLOCKS;
      if (second == WARM_UP_BLOCKS) {
        System.gc();
        collectedBeforeMs = collectionMs();
      }
      if (second % 2 == 0) {
        hands.run(BATCHES, measured ? bare : bareWarmingUp);
      } else {
        block(second / 2L * BATCHES, measured);
      }
    }
    settle();
    ended = true;
  }

  private void block(long firstBatch, boolean measured) {
    firmware.advance(firstBatch * BATCH_US);
    firmware.endPacket();
    settle();
    int stamp = (int) stamps.getLong(0);
    if (measured && firstMeasured == Long.MAX_VALUE) {
      firstMeasured = firstBatch;
    }
    long start = System.nanoTime();
    for (int i = 0; i < BATCHES; i++) {
      long due = start + TimeUnit.MICROSECONDS.toNanos((long) i * BATCH_US);
      while (System.nanoTime() < due) {
        LockSupport.parkNanos(due - System.nanoTime());
      }
      long batch = firstBatch + i;
      for (int event = 0; event < BATCH_US; event++) {
        long timeUs = batch * BATCH_US + event;
        firmware.event(timeUs, objects.x(timeUs), objects.y(timeUs), (event & 1) == 0);
      }
      int kept = (int) batch & KEPT - 1;
      stampOfBatch[kept] = stamp + i;
      sentNanos[kept] = System.nanoTime();
      firmware.endPacket();
    }
  }

  private void settle() {
    CameraBench.await(() -> device.queued(Dvs128Firmware.ENDPOINT) == 0);
    LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(50));
  }

  // ---- The consumer's side

  @Override
  public void packet(EventPacket packet) {
    long lastUs = packet.lastTimeUs();
    long begin = System.nanoTime();
    chain.process(packet);
    long now = System.nanoTime();
    long batch = lastUs / BATCH_US;
    boolean endsBatch = (lastUs + 1) % BATCH_US == 0;
    if (!endsBatch) {
      return;
    }
    workNanos += (now - begin - workNanos) / MEAN_OF;
    boolean measured = batch >= firstMeasured;
    int kept = (int) batch & KEPT - 1;
    long handedOver = stamps.getLong((1 + (stampOfBatch[kept] & KEPT - 1)) * Long.BYTES);
    if (handedOver < sentNanos[kept] || handedOver > now) {
      unmatched++;
    } else if (measured) {
      sinceHandedOver.add(now - handedOver);
      sinceSent.add(now - sentNanos[kept]);
    } else {
      warmingUp.add(now - handedOver);
    }
  }

  @Override
  public void notified(StreamNotification notification) {
    chain.notified(notification);
    losses += notification instanceof DataLost ? 1 : 0;
  }

  /** Measures and prints. */
  void run(Camera camera, int seconds) throws Exception {
    camera.next(this);
    Thread sender =
        new Thread(
            () -> {
              try {
                send(seconds);
              } catch (IOException problem) {
                throw new AssertionError(problem);
              }
            },
            "sender");
    sender.setDaemon(true);
    sender.start();
    while (!ended) {
      if (camera.await(TimeUnit.MILLISECONDS.toNanos(20))) {
        camera.next(this);
      }
    }
    print("from the emulated bus to the end of the chain", sinceHandedOver);
    print("the same with the emulated bus itself        ", sinceSent);
    print("bare threads that wake and work likewise      ", bare);
    print("the first in the seconds before, of warming up", warmingUp);
    System.out.println(
        "work of the chain "
            + workNanos / 1000
            + " us, losses "
            + losses
            + ", batches without a stamp "
            + unmatched
            + ", collections of the heap "
            + (collectionMs() - collectedBeforeMs)
            + " ms while it was measured; allocated:");
    allocations();
    System.out.println(camera.statistics());
  }

  private static void print(String what, LatencyHistogram histogram) {
    StringBuilder line = new StringBuilder(what);
    for (double share : SHARES) {
      line.append(
          String.format(Locale.ROOT, "  %.1f %% %d us", share * 100, histogram.quantileUs(share)));
    }
    System.out.println(line + "  longest " + histogram.longestUs() + " us");
  }

  private static long collectionMs() {
    return ManagementFactory.getGarbageCollectorMXBeans().stream()
        .mapToLong(GarbageCollectorMXBean::getCollectionTime)
        .sum();
  }

  /** Bytes allocated by each thread since its start. */
  private static void allocations() {
    var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    for (ThreadInfo thread : threads.getThreadInfo(threads.getAllThreadIds())) {
      long bytes = threads.getThreadAllocatedBytes(thread.getThreadId());
      if (bytes > 1_000_000) {
        System.out.printf(Locale.ROOT, "  %-24s %6.1f MB%n", thread.getThreadName(), bytes / 1e6);
      }
    }
  }
}
