package haltere.core.format;

import haltere.testing.FormatFuzzer;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Inputs of the fuzzer are read anew, each by every format: those that it made on its way to odd
 * places, and those that it found a fault with, which come here when the fault is corrected.
 */
class FuzzedFormatsTest {
  @TempDir Path folder;

  static List<Path> inputs() throws IOException {
    try (var all = Files.walk(Path.of("src/test/resources/fuzz"))) {
      return all.filter(Files::isRegularFile).sorted().toList();
    }
  }

  @ParameterizedTest
  @MethodSource("inputs")
  void inputOfTheFuzzerIsReadOrRejected(Path input) throws IOException {
    byte[] bytes = Files.readAllBytes(input);
    for (RecordingFormat format : Recordings.formats().values()) {
      FormatFuzzer.check(format, bytes, folder.resolve("input"));
    }
  }
}
