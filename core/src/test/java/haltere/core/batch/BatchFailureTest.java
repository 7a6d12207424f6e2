package haltere.core.batch;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.batch.BatchFailure.FailureKind;
import haltere.core.format.RecordingProblem;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

class BatchFailureTest {
  private static final Path FILE = Path.of("recording.raw");

  @Test
  void damagedRecordingIsARecordingFailure() {
    assertEquals(
        FailureKind.RECORDING, FailureKind.of(new RecordingProblem(FILE, "the file is empty")));
  }

  @Test
  void fullDiskIsAFileFailure() {
    IOException full = RecordingProblem.writing(FILE, new IOException("No space left on device"));
    assertEquals(FailureKind.FILES, FailureKind.of(full));
    assertEquals(FailureKind.FILES, FailureKind.of(new UncheckedIOException(full)));
  }

  @Test
  void faultyDiskAndMissingPermissionAreFileFailures() {
    assertEquals(
        FailureKind.FILES,
        FailureKind.of(RecordingProblem.reading(FILE, 8, new IOException("Input/output error"))));
    assertEquals(FailureKind.FILES, FailureKind.of(new AccessDeniedException("folder")));
  }
}
