package haltere.ui.viewer;

import haltere.core.playback.Loop;
import haltere.ui.viewer.saving.ExportFeature;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.locks.LockSupport;
import javafx.application.Platform;

/**
 * Measures how long the JavaFX thread is kept busy at one go while a recording is opened, sought
 * and exported. Counts the CPU time that the thread takes before it gives a sign of life, so that
 * other programs on the machine do not matter, and real time as well.
 *
 * <p>As a program, for a large file: {@code ./gradlew :ui:blockBenchmark --args=FILE}.
 */
final class UiBlocks implements AutoCloseable {
  private static final long PROBE_NANOS = 1_000_000;
  private static final long LONGEST_EXPORT_US = 30_000_000;

  private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
  private final Thread probe = new Thread(this::probe, "block-probe");
  private volatile boolean ended;
  private volatile double longestCpuMs;
  private volatile double longestMs;

  UiBlocks() {
    probe.setDaemon(true);
    probe.start();
  }

  private void probe() {
    CompletableFuture<Long> found = new CompletableFuture<>();
    Platform.runLater(() -> found.complete(Thread.currentThread().getId()));
    long javaFxThread = found.join();
    while (!ended) {
      long asked = System.nanoTime();
      long cpuBefore = threads.getThreadCpuTime(javaFxThread);
      CompletableFuture<Long> cpu = new CompletableFuture<>();
      Platform.runLater(() -> cpu.complete(threads.getCurrentThreadCpuTime()));
      longestCpuMs = Math.max(longestCpuMs, (cpu.join() - cpuBefore) / 1e6);
      longestMs = Math.max(longestMs, (System.nanoTime() - asked) / 1e6);
      LockSupport.parkNanos(PROBE_NANOS);
    }
  }

  /** CPU time that the JavaFX thread took at one go, at most, so far. */
  double longestCpuMs() {
    return longestCpuMs;
  }

  /** Real time that something waited for the JavaFX thread, at most, so far. */
  double longestMs() {
    return longestMs;
  }

  @Override
  public void close() {
    ended = true;
  }

  /** Opens, seeks and exports, and waits until all of that is done. */
  static void work(ViewerHarness viewer, Path recording, Path target) {
    viewer.openRecording(recording);
    long durationUs = viewer.status().durationUs();
    for (int i = 1; i <= 10; i++) {
      long placeUs = durationUs * (i * 7 % 11) / 11;
      viewer.run(() -> viewer.window.context().playback().seek(placeUs));
      viewer.waitFor("there", () -> viewer.status().elapsedUs() >= placeUs);
    }
    exportPart(viewer, durationUs, target);
  }

  /** Of a long recording the last half minute, so that it comes to an end in the usual patience. */
  private static void exportPart(ViewerHarness viewer, long durationUs, Path target) {
    long fromUs = Math.max(0, durationUs - LONGEST_EXPORT_US);
    viewer.run(() -> viewer.window.context().playback().seek(fromUs));
    viewer.waitFor("there", () -> viewer.status().elapsedUs() >= fromUs);
    viewer.run(viewer.window.context().playback()::markIn);
    viewer.run(() -> ViewerHarness.join(viewer.session().player().setLoop(Loop.OFF)));
    viewer.run(() -> viewer.window.feature(ExportFeature.class).exportData(target));
    viewer.waitFor(
        "the export",
        () -> viewer.text("status-message").startsWith("Exported " + target.getFileName()));
  }

  /**
   * Runs.
   *
   * @param args a recording, and where its copy may be written
   */
  public static void main(String[] args) throws IOException {
    Path recording = Path.of(args[0]);
    try (ViewerHarness viewer = new ViewerHarness()) {
      // a window that has just started shows the scene
      viewer.run(() -> viewer.window.context().actions().run("open-scene"));
      viewer.waitFor("the scene", () -> viewer.window.context().panels().framesShown() > 60);
      UiBlocks blocks = new UiBlocks();
      work(viewer, recording, Path.of(args[1]));
      blocks.close();
      System.out.printf(
          Locale.ROOT,
          "longest block of the JavaFX thread: %.1f ms of its CPU time, %.1f ms of real time%n",
          blocks.longestCpuMs(),
          blocks.longestMs());
    }
    System.exit(0);
  }
}
