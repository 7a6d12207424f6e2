package haltere.ui.viewer.feature;

import haltere.core.stream.internal.Daemon;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import javafx.application.Platform;

/**
 * Threads for what would make the window wait: one opens, saves and closes, one scans, one exports.
 * Results come back on the JavaFX thread.
 */
public final class BackgroundWork implements AutoCloseable {
  private final ExecutorService files = thread("haltere-files");
  private final ExecutorService exports = thread("haltere-export");
  private final ExecutorService scans = thread("haltere-scan");
  private final AtomicBoolean closed = new AtomicBoolean();
  private Future<?> scan = CompletableFuture.completedFuture(null);

  private static ExecutorService thread(String name) {
    return Executors.newSingleThreadExecutor(work -> Daemon.thread(work, name));
  }

  /** Opens or saves something. */
  public <T> void file(Callable<T> work, Consumer<T> done, Consumer<Exception> failed) {
    files.submit(() -> run(work, done, failed));
  }

  /** Work without a result. */
  @FunctionalInterface
  public interface Action {
    /** In the background. */
    void run() throws Exception;
  }

  /** Does something with files that has no result. */
  public void file(Action work, Runnable done, Consumer<Exception> failed) {
    file(
        () -> {
          work.run();
          return work;
        },
        finished -> done.run(),
        failed);
  }

  /** Closes something; what that throws has no one to tell. */
  public void close(AutoCloseable something) {
    file(something::close, () -> {}, failed -> {});
  }

  /**
   * Exports something, which may take long; what was asked for before is done first. Cancelling
   * ends it.
   */
  public <T> Future<?> export(Callable<T> work, Consumer<T> done, Consumer<Exception> failed) {
    return exports.submit(() -> run(work, done, failed));
  }

  /** Scans something, in place of what is being scanned. */
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

  /** Finishes what was handed over and ends the threads; nothing more comes back. */
  @Override
  public void close() {
    closed.set(true);
    scans.shutdownNow();
    exports.shutdownNow();
    files.shutdown();
  }
}
