package haltere.core.stream.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.UncheckedIOException;
import org.junit.jupiter.api.Test;

class ReasonTest {
  @Test
  void reasonOfAFileIsThatOfTheWrappedFailure() {
    IOException full = new IOException("No space left on device");
    assertEquals("No space left on device", Reason.of(full));
    assertEquals("No space left on device", Reason.of(new UncheckedIOException(full)));
    assertEquals("java.io.IOException", Reason.of(new UncheckedIOException(new IOException())));
  }
}
