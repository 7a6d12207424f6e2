package haltere.ui.viewer;

import static org.junit.jupiter.api.Assertions.fail;

import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.locks.LockSupport;
import javafx.application.Platform;

/**
 * Brings what a test does to the JavaFX thread, and waits for what comes of it.
 *
 * <p>Thread rule: the test's thread, or JavaFX's own.
 */
abstract class JavaFxHarness {
  private static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(30);
  private static final CompletableFuture<Void> STARTED = new CompletableFuture<>();

  static {
    Platform.startup(() -> STARTED.complete(null));
    Platform.setImplicitExit(false);
  }

  JavaFxHarness() {
    STARTED.join();
  }

  /** What there is to read where a test waits in vain; JavaFX thread. */
  abstract String said();

  /** Calls something on the JavaFX thread. */
  public <T> T onFx(Callable<T> call) {
    if (Platform.isFxApplicationThread()) {
      try {
        return call.call();
      } catch (Exception broken) {
        throw new AssertionError(broken);
      }
    }
    CompletableFuture<T> result = new CompletableFuture<>();
    Platform.runLater(
        () -> {
          try {
            result.complete(call.call());
          } catch (Throwable thrown) {
            result.completeExceptionally(thrown);
          }
        });
    return join(result);
  }

  /** Runs something on the JavaFX thread. */
  public void run(Runnable action) {
    onFx(
        () -> {
          action.run();
          return null;
        });
  }

  /** Waits for a condition, which is asked on the JavaFX thread between pulses. */
  public void waitFor(String what, Callable<Boolean> condition) {
    long start = System.nanoTime();
    while (!onFx(condition)) {
      if (System.nanoTime() - start > PATIENCE_NANOS) {
        fail("waited in vain for: " + what + "; the window says: " + onFx(this::said));
      }
      LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(4));
    }
  }

  static <T> T join(CompletableFuture<T> future) {
    try {
      return future.get(PATIENCE_NANOS, TimeUnit.NANOSECONDS);
    } catch (ExecutionException failed) {
      if (failed.getCause() instanceof Error error) {
        throw error;
      }
      throw new AssertionError(failed.getCause());
    } catch (InterruptedException | TimeoutException broken) {
      throw new AssertionError(broken);
    }
  }
}
