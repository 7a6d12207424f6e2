package haltere.ui.viewer.feature;

import haltere.core.stream.internal.Daemon;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import javafx.application.Platform;

/**
 * Threads for long tasks: one for files, one for scans, one for exports. Results return on the
 * JavaFX thread.
 */
public final class BackgroundWork implements AutoCloseable {
  private static final long EXIT_TIMEOUT_S = 10;

  private final ExecutorService files = thread("haltere-files");
  private final ExecutorService exports = thread("haltere-export");
  private final ExecutorService scans = thread("haltere-scan");
  private final AtomicBoolean closed = new AtomicBoolean();
  private Future<?> scan = CompletableFuture.completedFuture(null);

  private static ExecutorService thread(String name) {
    return Executors.newSingleThreadExecutor(work -> Daemon.thread(work, name));
  }

  /** Opens or saves a file. */
  public <T> void file(Callable<T> work, Consumer<T> done, Consumer<Exception> failed) {
    files.submit(() -> run(work, done, failed));
  }

  /** Work without a result. */
  @FunctionalInterface
  public interface Action {
    /** In the background. */
    void run() throws Exception;
  }

  /** Runs a file task without a result. */
  public void file(Action work, Runnable done, Consumer<Exception> failed) {
    file(
        () -> {
          work.run();
          return work;
        },
        finished -> done.run(),
        failed);
  }

  /** Closes a resource; its exceptions are ignored. */
  public void close(AutoCloseable resource) {
    file(resource::close, () -> {}, failed -> {});
  }

  /** Exports, which may take long, after earlier exports. Cancelling stops it. */
  public <T> Future<?> export(Callable<T> work, Consumer<T> done, Consumer<Exception> failed) {
    return exports.submit(() -> run(work, done, failed));
  }

  /** Scans, in place of a running scan. */
  public <T> void scan(Callable<T> work, Consumer<T> done, Consumer<Exception> failed) {
    scan.cancel(true);
    scan = scans.submit(() -> run(work, done, failed));
  }

  private <T> void run(Callable<T> work, Consumer<T> done, Consumer<Exception> failed) {
    try {
      T result = work.call();
      later(() -> done.accept(result));
    } catch (Exception problem) {
      later(() -> failed.accept(problem));
    }
  }

  private void later(Runnable action) {
    if (!closed.get()) {
      Platform.runLater(action);
    }
  }

  /**
   * Ends the threads; results are discarded. Waits until an interrupted export has removed its
   * files and queued file tasks are finished, such as the end of a recording.
   */
  @Override
  public void close() {
    closed.set(true);
    scans.shutdownNow();
    exports.shutdownNow();
    files.shutdown();
    try {
      exports.awaitTermination(EXIT_TIMEOUT_S, TimeUnit.SECONDS);
      files.awaitTermination(EXIT_TIMEOUT_S, TimeUnit.SECONDS);
    } catch (InterruptedException again) {
      Thread.currentThread().interrupt();
    }
  }
}
