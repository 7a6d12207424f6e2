package haltere.device.model;

import haltere.core.camera.Camera;
import haltere.core.camera.CameraOptions;
import haltere.core.stream.StreamStarted;
import haltere.testing.usb.Dvs128Firmware;
import haltere.testing.usb.EmulatedDevice;
import haltere.testing.usb.UsbEmulator;
import java.io.File;
import java.io.IOException;
import java.lang.management.BufferPoolMXBean;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.lang.management.ThreadMXBean;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/**
 * Measures the driver of the DVS128 on emulated USB, all of it in this program: {@code endure},
 * {@code latency}, {@code speed}, {@code idle} or {@code replug}, then seconds (of {@code replug},
 * times) and events per second.
 */
final class CameraMeasurement {
  private static final int BATCH_US = 1000;
  private static final long LATEST_NANOS = TimeUnit.MILLISECONDS.toNanos(100);
  private static final long WRAP_US = 1 << 14;
  private static final int PACKET_BYTES = 512;

  private static final Path FOLDER = Path.of(System.getenv("USBEMU_DIR"));

  private final UsbEmulator emulator;
  private final Dvs128Firmware firmware = new Dvs128Firmware("0001");
  private EmulatedDevice device;
  private volatile boolean ended;

  private CameraMeasurement() throws IOException {
    emulator = new UsbEmulator(FOLDER);
    device = emulator.plug(2, firmware);
  }

  /**
   * Measures.
   *
   * @param args what, seconds, events per second
   * @throws Exception if something breaks
   */
  public static void main(String[] args) throws Exception {
    CameraMeasurement measurement = new CameraMeasurement();
    int seconds = Integer.parseInt(args[1]);
    int rate = Integer.parseInt(args[2]);
    switch (args[0]) {
      case "endure" -> measurement.endure(seconds, rate);
      case "latency" -> measurement.latency(seconds);
      case "speed" -> measurement.speed(seconds);
      case "replug" -> measurement.replug(seconds);
      case "idle" -> measurement.idle(seconds);
      default -> throw new IllegalArgumentException(args[0]);
    }
    System.exit(0);
  }

  private Camera open(CameraOptions options) throws IOException {
    UsbCameraProvider provider = new UsbCameraProvider();
    CameraBench.await(() -> !provider.list().isEmpty());
    return provider.open(provider.list().get(0), options);
  }

  private static void start(Camera camera, StreamLog log) throws IOException {
    log.untilA(StreamStarted.class);
  }

  /** Sends a batch for each millisecond that goes by; returns the events sent. */
  private long send(int seconds, int rate) {
    int perBatch = rate / (1_000_000 / BATCH_US);
    long start = System.nanoTime();
    long batches = seconds * (1_000_000L / BATCH_US);
    for (long batch = 0; batch < batches; batch++) {
      long due = start + batch * TimeUnit.MICROSECONDS.toNanos(BATCH_US);
      long late = System.nanoTime() - due;
      if (late > LATEST_NANOS) {
        start += late; // the whole program stood still: a camera would have stood with it
      }
      while (System.nanoTime() < due) {
        LockSupport.parkNanos(due - System.nanoTime());
      }
      for (int i = 0; i < perBatch; i++) {
        int cell = (int) (batch * 31 + i * 17L);
        firmware.event(
            batch * BATCH_US + (long) i * BATCH_US / perBatch,
            cell & 127,
            cell >> 7 & 127,
            (i & 1) == 0);
      }
      firmware.endPacket();
    }
    return batches * perBatch;
  }

  private Thread sender(int seconds, int rate) {
    Thread thread =
        new Thread(
            () -> {
              send(seconds, rate);
              CameraBench.await(() -> device.queued(Dvs128Firmware.ENDPOINT) == 0);
              LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(300));
              ended = true;
            });
    thread.setDaemon(true);
    thread.start();
    return thread;
  }

  // ---- One hour of streaming

  private void endure(int seconds, int rate) throws Exception {
    try (Camera camera = open(CameraOptions.DEFAULT)) {
      StreamLog log = new StreamLog(camera, false);
      start(camera, log);
      sender(seconds, rate);
      long begin = System.nanoTime();
      long nextReport = 0;
      while (!ended) {
        log.drain();
        camera.await(TimeUnit.MILLISECONDS.toNanos(20));
        long elapsedS = (System.nanoTime() - begin) / 1_000_000_000L;
        if (elapsedS >= nextReport) {
          report(elapsedS, camera, log);
          nextReport = elapsedS + 60;
        }
      }
      log.drain();
      report((System.nanoTime() - begin) / 1_000_000_000L, camera, log);
      System.out.println(
          firmware.eventsSent() == log.events + log.lost
              ? "all accounted for"
              : "not accounted for: " + (firmware.eventsSent() - log.events - log.lost));
    }
  }

  private void report(long elapsedS, Camera camera, StreamLog log) {
    System.gc();
    Runtime runtime = Runtime.getRuntime();
    long direct =
        ManagementFactory.getPlatformMXBeans(BufferPoolMXBean.class).stream()
            .mapToLong(BufferPoolMXBean::getMemoryUsed)
            .sum();
    String[] files = new File("/proc/self/fd").list();
    System.out.printf(
        Locale.ROOT,
        "%5d s: %,d events, %,d lost, heap %.1f MB, direct %.1f MB, %d files, %d threads, %s%n",
        elapsedS,
        log.events,
        camera.statistics().lostEvents(),
        (runtime.totalMemory() - runtime.freeMemory()) / 1e6,
        direct / 1e6,
        files == null ? -1 : files.length,
        Thread.activeCount(),
        camera.statistics());
  }

  // ---- Latency

  private void latency(int seconds) throws Exception {
    LatencyMeasurement measurement = new LatencyMeasurement(firmware, device, FOLDER);
    try (Camera camera = open(CameraOptions.DEFAULT)) {
      measurement.run(camera, seconds);
    }
  }

  // ---- Coming back

  /** From the moment that it is plugged in again to the beginning of its stream. */
  private void replug(int times) throws Exception {
    LatencyHistogram histogram = new LatencyHistogram();
    try (Camera camera = open(CameraOptions.DEFAULT.withReconnect(true))) {
      StreamLog log = new StreamLog(camera);
      start(camera, log);
      for (int time = 1; time <= times; time++) {
        int streams = time + 1;
        device.unplug();
        log.until(() -> log.ends() == streams - 1);
        log.drain();
        device = emulator.plug(2 + time % 100, new Dvs128Firmware("0001"));
        long begin = System.nanoTime();
        while (camera.statistics().streams() < streams) {
          log.drain();
          camera.await(TimeUnit.MILLISECONDS.toNanos(20));
        }
        histogram.add(System.nanoTime() - begin);
      }
    }
    System.out.printf(
        Locale.ROOT,
        "back after %.1f ms (half of %d times), %.1f ms (99 %%), %.1f ms at the most%n",
        histogram.quantileUs(0.5) / 1e3,
        times,
        histogram.quantileUs(0.99) / 1e3,
        histogram.longestUs() / 1e3);
  }

  // ---- Speed

  private void speed(int seconds) throws Exception {
    try (Camera camera = open(CameraOptions.DEFAULT.withBuffers(8, 65_536, 64))) {
      StreamLog log = new StreamLog(camera, false);
      start(camera, log);
      byte[] packet = new byte[PACKET_BYTES];
      device.limitQueue(4096);
      Thread sender =
          new Thread(
              () -> {
                long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(seconds);
                while (System.nanoTime() < end) {
                  if (!device.send(Dvs128Firmware.ENDPOINT, packet)) {
                    Thread.onSpinWait();
                  }
                }
                ended = true;
              });
      long begin = System.nanoTime();
      sender.start();
      while (!ended) {
        log.drain();
        camera.await(TimeUnit.MILLISECONDS.toNanos(20));
      }
      double elapsedS = (System.nanoTime() - begin) / 1e9;
      System.out.printf(
          Locale.ROOT,
          "%.1f million events per second through libusb, %d lost, all accounted for: %s%n",
          log.events / elapsedS / 1e6,
          log.lost,
          log.events + camera.statistics().lostEvents() <= firmware.eventsSent());
    }
  }

  // ---- Idle

  private void idle(int seconds) throws Exception {
    try (Camera camera = open(CameraOptions.DEFAULT)) {
      start(camera, new StreamLog(camera));
      // A camera that sees nothing still tells the time, every 16 ms.
      Thread sender =
          new Thread(
              () -> {
                for (long us = 0; !ended; us += WRAP_US) {
                  firmware.advance(us);
                  firmware.endPacket();
                  LockSupport.parkNanos(TimeUnit.MICROSECONDS.toNanos(WRAP_US));
                }
              });
      sender.start();
      camera.await(TimeUnit.SECONDS.toNanos(2));
      long before = driverCpuNanos();
      long beforeAll = cpuMs();
      long begin = System.nanoTime();
      camera.await(TimeUnit.SECONDS.toNanos(seconds));
      double elapsedNanos = System.nanoTime() - begin;
      System.out.printf(
          Locale.ROOT,
          "driver %.2f %% of a core; with the emulator %.2f %%%n",
          (driverCpuNanos() - before) * 100 / elapsedNanos,
          (cpuMs() - beforeAll) * 1e8 / elapsedNanos);
      ended = true;
    }
  }

  /** Processor time of the consumer's thread and of the bus thread. */
  private static long driverCpuNanos() {
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    long used = 0;
    for (ThreadInfo thread : threads.getThreadInfo(threads.getAllThreadIds())) {
      if (thread.getThreadName().equals("haltere-usb") || thread.getThreadName().equals("main")) {
        used += threads.getThreadCpuTime(thread.getThreadId());
      }
    }
    return used;
  }

  private static long cpuMs() {
    return ProcessHandle.current().info().totalCpuDuration().orElseThrow().toMillis();
  }
}
