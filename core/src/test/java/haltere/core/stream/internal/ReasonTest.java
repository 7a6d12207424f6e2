package haltere.core.stream.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import org.junit.jupiter.api.Test;

class ReasonTest {
  @Test
  void reasonOfAFileIsThatOfTheWrappedFailure() {
    IOException full = new IOException("No space left on device");
    assertEquals("No space left on device", Reason.of(full));
    assertEquals("No space left on device", Reason.of(new UncheckedIOException(full)));
    assertEquals("java.io.IOException", Reason.of(new UncheckedIOException(new IOException())));
  }

  @Test
  void failureOfTheSystemNamesFileAndReason() {
    assertEquals(
        "a.csv: there is no such file or folder", Reason.of(new NoSuchFileException("a.csv")));
    assertEquals("a.csv: no permission", Reason.of(new AccessDeniedException("a.csv")));
    FileSystemException full = new FileSystemException("a.csv", null, "File too large");
    assertEquals("a.csv: File too large", Reason.of(full));
    assertEquals("File too large", Reason.withoutFile(full));
    assertEquals("a.csv: cannot be used", Reason.of(new FileSystemException("a.csv")));
    assertEquals("there is no such file or folder", Reason.of(new NoSuchFileException(null)));
  }
}
