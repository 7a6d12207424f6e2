package haltere.testing;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.engine.UniqueId;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;
import org.junit.platform.launcher.TestPlan;

/**
 * Ends the process where a test has no end, so that a run of tests always has one. The test and the
 * stacks of all threads are written to the file that the property {@value #FILE_PROPERTY} names.
 * JUnit's own time limits interrupt the thread of a test, which a test that reads from a socket or
 * looks at a condition does not notice.
 */
public final class StuckTests implements TestExecutionListener {
  private static final String FILE_PROPERTY = "haltere.stuck";

  /** Several times what the longest test takes on a busy machine with two processors. */
  private static final Duration LIMIT = Duration.ofMinutes(6);

  private static final Duration PERIOD = Duration.ofSeconds(5);
  private static final int EXIT_STATUS = 3;

  private final Map<UniqueId, Long> beganNanos = new ConcurrentHashMap<>();
  private ScheduledExecutorService watch;

  @Override
  public void testPlanExecutionStarted(TestPlan plan) {
    String file = System.getProperty(FILE_PROPERTY);
    if (file == null) {
      return;
    }
    watch =
        Executors.newSingleThreadScheduledExecutor(
            task -> {
              Thread thread = new Thread(task, "stuck-tests");
              thread.setDaemon(true);
              return thread;
            });
    watch.scheduleAtFixedRate(
        () -> look(Path.of(file)), PERIOD.toMillis(), PERIOD.toMillis(), TimeUnit.MILLISECONDS);
  }

  @Override
  public void testPlanExecutionFinished(TestPlan plan) {
    if (watch != null) {
      watch.shutdownNow();
    }
  }

  @Override
  public void executionStarted(TestIdentifier test) {
    if (test.isTest()) {
      beganNanos.put(test.getUniqueIdObject(), System.nanoTime());
    }
  }

  @Override
  public void executionFinished(TestIdentifier test, TestExecutionResult result) {
    beganNanos.remove(test.getUniqueIdObject());
  }

  private void look(Path file) {
    long nowNanos = System.nanoTime();
    beganNanos.forEach(
        (test, began) -> {
          if (nowNanos - began > LIMIT.toNanos()) {
            end(file, test);
          }
        });
  }

  private static void end(Path file, UniqueId test) {
    StringBuilder said = new StringBuilder("no end after " + LIMIT + ": " + test + "\n\n");
    for (ThreadInfo thread : ManagementFactory.getThreadMXBean().dumpAllThreads(true, true)) {
      said.append('"').append(thread.getThreadName()).append("\" ").append(thread.getThreadState());
      said.append(thread.getLockName() == null ? "" : " on " + thread.getLockName());
      said.append(thread.getLockOwnerName() == null ? "" : " of " + thread.getLockOwnerName());
      said.append('\n');
      for (StackTraceElement frame : thread.getStackTrace()) {
        said.append("\tat ").append(frame).append('\n');
      }
    }
    try {
      Files.createDirectories(file.toAbsolutePath().getParent());
      Files.writeString(file, said);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } finally {
      Runtime.getRuntime().halt(EXIT_STATUS);
    }
  }
}
