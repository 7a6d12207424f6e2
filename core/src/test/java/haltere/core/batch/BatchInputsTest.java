package haltere.core.batch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BatchInputsTest {
  @TempDir Path folder;
  private Path locked;

  @BeforeEach
  void lockAFolder() throws IOException {
    Files.writeString(folder.resolve("a.aedat"), "#!AER-DAT2.0\n");
    locked = Files.createDirectory(folder.resolve("locked"));
    setPermissions("---------");
    Assumptions.assumeFalse(
        Files.isReadable(locked), "whoever runs this test may read every folder (root)");
  }

  @AfterEach
  void unlock() throws IOException {
    setPermissions("rwx------");
  }

  private void setPermissions(String permissions) throws IOException {
    Files.setPosixFilePermissions(locked, PosixFilePermissions.fromString(permissions));
  }

  @Test
  void unreadableFolderFailsBesideTheRecordings() throws IOException {
    BatchInputs inputs = new BatchInputs(folder.resolve("results"), Optional.empty());
    inputs.add(folder);
    assertEquals(
        List.of("a.aedat", "locked"), inputs.items().stream().map(BatchItem::name).toList());
  }

  @Test
  void unreadableInputIsRefused() {
    BatchInputs inputs = new BatchInputs(folder.resolve("results"), Optional.empty());
    assertThrows(AccessDeniedException.class, () -> inputs.add(locked));
  }
}
