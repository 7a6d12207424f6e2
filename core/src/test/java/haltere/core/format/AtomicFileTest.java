package haltere.core.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** An output file appears complete or not at all. */
class AtomicFileTest {
  @TempDir Path folder;

  private List<String> names() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.map(file -> file.getFileName().toString()).sorted().toList();
    }
  }

  private static void write(AtomicFile file, String text) throws IOException {
    file.stream().write(text.getBytes(StandardCharsets.UTF_8));
  }

  @Test
  void committedFilesAppear() throws IOException {
    Path target = folder.resolve("a.txt");
    try (AtomicFile file = AtomicFile.create(target, false)) {
      write(file, "whole");
      assertFalse(Files.exists(target));
      file.commit();
      assertThrows(IllegalStateException.class, file::commit);
    }
    assertEquals("whole", Files.readString(target));
    assertEquals(List.of("a.txt"), names());
  }

  @Test
  void uncommittedFilesLeaveNothing() throws IOException {
    try (AtomicFile file = AtomicFile.create(folder.resolve("a.txt"), false)) {
      write(file, "half");
      assertEquals(1, names().size());
      assertTrue(names().get(0).startsWith("."), names().get(0));
    }
    assertEquals(List.of(), names());
  }

  @Test
  void existingFileRemainsUntilTheNewOneIsComplete() throws IOException {
    Path target = Files.writeString(folder.resolve("a.txt"), "old");
    assertThrows(RecordingProblem.class, () -> AtomicFile.create(target, false));
    try (AtomicFile file = AtomicFile.create(target, true)) {
      write(file, "new");
      assertEquals("old", Files.readString(target));
    }
    assertEquals("old", Files.readString(target));
    try (AtomicFile file = AtomicFile.create(target, true)) {
      write(file, "new");
      file.commit();
    }
    assertEquals("new", Files.readString(target));
    assertEquals(List.of("a.txt"), names());
  }

  @Test
  void messagesNameTheTargetInsteadOfTheTemporaryFile() throws IOException {
    Path target = folder.resolve("a.txt");
    try (AtomicFile file = AtomicFile.create(target, false)) {
      write(file, "mine");
      Files.delete(folder.resolve(names().get(0)));
      String message = assertThrows(RecordingProblem.class, file::commit).getMessage();
      assertEquals(target + ": cannot be written: there is no such file or folder", message);
    }
  }

  @Test
  void filesThatAppearMeanwhileAreNotReplaced() throws IOException {
    Path target = folder.resolve("a.txt");
    try (AtomicFile file = AtomicFile.create(target, false)) {
      write(file, "mine");
      Files.writeString(target, "theirs");
      assertThrows(RecordingProblem.class, file::commit);
    }
    assertEquals("theirs", Files.readString(target));
    assertEquals(List.of("a.txt"), names());
  }

  @Test
  void targetOfASymbolicLinkIsReplaced() throws IOException {
    Path real = Files.writeString(folder.resolve("real.txt"), "old");
    Path link = Files.createSymbolicLink(folder.resolve("link.txt"), real);
    try (AtomicFile file = AtomicFile.create(link, true)) {
      write(file, "new");
      file.commit();
    }
    assertTrue(Files.isSymbolicLink(link));
    assertEquals("new", Files.readString(real));
  }

  @Test
  void foldersAndPathsInMissingFoldersAreRejected() throws IOException {
    assertThrows(RecordingProblem.class, () -> AtomicFile.create(folder, true));
    RecordingProblem problem =
        assertThrows(
            RecordingProblem.class,
            () -> AtomicFile.create(folder.resolve("no").resolve("a.txt"), true));
    assertTrue(problem.getMessage().contains("folder does not exist"), problem.getMessage());
  }

  @ParameterizedTest
  @CsvSource({
    "No space left on device, make room",
    "File too large, ulimit -f",
    "Input/output error, copy what can be read",
    "Read-only file system, choose another place"
  })
  void systemErrorsAreReportedWithFileCauseAndRemedy(String cause, String advice)
      throws IOException {
    OutputStream full =
        new OutputStream() {
          @Override
          public void write(int value) throws IOException {
            throw new IOException(cause);
          }
        };
    try (AtomicFile file = AtomicFile.on(Path.of("fly.es"), full)) {
      ByteBuffer bytes = ByteBuffer.allocate(9);
      String said = assertThrows(RecordingProblem.class, () -> file.write(bytes)).getMessage();
      assertTrue(said.startsWith("fly.es: cannot be written: " + cause), said);
      assertTrue(said.contains(advice), said);
    }
    String read = RecordingProblem.reading(Path.of("a"), 7, new IOException(cause)).getMessage();
    assertTrue(read.startsWith("a, byte 7: cannot be read: " + cause), read);
  }
}
