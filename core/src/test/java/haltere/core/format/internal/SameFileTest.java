package haltere.core.format.internal;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Files that would be written onto themselves. */
class SameFileTest {
  @TempDir Path folder;

  @Test
  void linkAndDetourLeadToTheSameFile() throws IOException {
    Path file = Files.createFile(folder.resolve("a.aedat4"));
    Path link = Files.createSymbolicLink(folder.resolve("link.aedat4"), file);
    assertTrue(SameFile.is(file, link));
    assertTrue(SameFile.is(file, folder.resolve("..").resolve(folder.getFileName() + "/a.aedat4")));
    assertFalse(SameFile.is(file, Files.createFile(folder.resolve("b.aedat4"))));
  }

  @Test
  void missingFilesAreComparedByName() throws IOException {
    Path missing = folder.resolve("a.aedat4");
    assertTrue(SameFile.is(missing, folder.resolve(".").resolve("a.aedat4")));
    assertFalse(SameFile.is(missing, folder.resolve("b.aedat4")));
  }
}
