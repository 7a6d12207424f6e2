package haltere.testing;

import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;

/**
 * Prints one line with the reason for every test that did not run, which Gradle's own log does not
 * know. The build shows lines that begin so.
 */
public final class SkippedTests implements TestExecutionListener {
  private static final String PREFIX = "SKIPPED ";

  @Override
  public void executionSkipped(TestIdentifier test, String reason) {
    print(test, reason);
  }

  @Override
  public void executionFinished(TestIdentifier test, TestExecutionResult result) {
    if (result.getStatus() == TestExecutionResult.Status.ABORTED) {
      print(test, result.getThrowable().map(Throwable::getMessage).orElse("no reason given"));
    }
  }

  private static void print(TestIdentifier test, String reason) {
    String place = test.getUniqueIdObject().toString().replaceAll("\\[engine:[^]]*]/", "");
    System.out.println(PREFIX + place.replaceAll("\\[[a-z-]+:|]", "") + ": " + reason);
  }
}
