package haltere.testing;

import com.code_intelligence.jazzer.api.BugDetectors;
import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;

/**
 * Has a fuzzer look for what people and peers say that is neither understood nor refused in one
 * line; one test for each of {@link TextFuzzer}'s checks.
 */
class TextFuzzTest {
  private static final String TIME = "10m";

  @FuzzTest(maxDuration = TIME)
  void chain(byte[] bytes) throws IOException {
    TextFuzzer.checkChain(bytes);
  }

  @FuzzTest(maxDuration = TIME)
  void settings(byte[] bytes) throws IOException {
    TextFuzzer.checkSettings(bytes);
  }

  @FuzzTest(maxDuration = TIME)
  void camera(byte[] bytes) throws IOException {
    TextFuzzer.checkCamera(bytes);
  }

  @FuzzTest(maxDuration = TIME)
  void address(byte[] bytes) {
    TextFuzzer.checkAddress(bytes);
  }

  @FuzzTest(maxDuration = TIME)
  void subscriber(byte[] bytes) throws IOException {
    BugDetectors.allowNetworkConnections();
    TextFuzzer.checkSubscriber(bytes);
  }
}
