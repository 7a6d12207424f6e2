package haltere.ui.command.terminal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class StandardOutputTest {
  private static Optional<String> failureWith(String message) {
    StandardOutput output =
        new StandardOutput(
            new OutputStream() {
              @Override
              public void write(int value) throws IOException {
                throw new IOException(message);
              }
            });
    try (PrintStream stream = new PrintStream(output, true, StandardCharsets.UTF_8)) {
      stream.println("a result");
    }
    return output.failure();
  }

  @Test
  void closedReaderIsNoFailure() {
    assertEquals(Optional.empty(), failureWith("Broken pipe"));
  }

  @Test
  void fullDiskIsAFailure() {
    assertEquals(
        Optional.of("the standard output cannot be written: No space left on device"),
        failureWith("No space left on device"));
  }

  @Test
  void writtenBytesArrive() throws IOException {
    java.io.ByteArrayOutputStream bytes = new java.io.ByteArrayOutputStream();
    StandardOutput output = new StandardOutput(bytes);
    output.write("hal".getBytes(StandardCharsets.UTF_8));
    output.write('t');
    assertEquals("halt", bytes.toString(StandardCharsets.UTF_8));
    assertEquals(Optional.empty(), output.failure());
  }
}
