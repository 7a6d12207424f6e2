package haltere.core.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.github.luben.zstd.Zstd;
import haltere.core.format.summary.RecordingSummary;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Files other than recordings are rejected in one line with their name. */
class BadInputTest {
  private static final byte[] PNG = {
    (byte) 0x89,
    'P',
    'N',
    'G',
    '\r',
    '\n',
    0x1a,
    '\n',
    0,
    0,
    0,
    13,
    'I',
    'H',
    'D',
    'R',
    0,
    0,
    4,
    0,
    0,
    0,
    3,
    0,
    8,
    2,
    0,
    0,
    0,
    (byte) 0xcf,
    (byte) 0x3e,
    (byte) 0x3c,
    (byte) 0xc2,
    0,
    0,
    0,
    1
  };

  @TempDir Path folder;

  private RecordingProblem refused(Path file) {
    RecordingProblem problem =
        assertThrows(RecordingProblem.class, () -> Recordings.open(file).close());
    assertTrue(problem.getMessage().startsWith(file + ": "), problem.getMessage());
    assertEquals(1, problem.getMessage().lines().count(), problem.getMessage());
    return problem;
  }

  private static void assertSays(String words, RecordingProblem problem) {
    assertTrue(problem.getMessage().contains(words), problem.getMessage());
  }

  @Test
  void emptyFileIsRejected() throws IOException {
    assertSays("empty", refused(Files.createFile(folder.resolve("empty.aedat"))));
  }

  @Test
  void missingFileIsRejected() {
    assertSays("no such file", refused(folder.resolve("missing.aedat")));
  }

  @Test
  void unreadableFilesAreRejected() throws IOException {
    Path file = Files.writeString(folder.resolve("secret.aedat"), "#!AER-DAT2.0\n");
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("---------"));
    Assumptions.assumeFalse(
        Files.isReadable(file), "whoever runs this test may read every file (root)");
    assertSays("no permission", refused(file));
  }

  @Test
  void picturesNamedLikeRecordingsAreRejectedWithEachFormatsReason() throws IOException {
    for (String name : new String[] {"picture.aedat", "picture.dat"}) {
      RecordingProblem problem = refused(Files.write(folder.resolve(name), PNG));
      assertSays("aedat1: ", problem);
      assertSays("aedat2: it has no line #!AER-DAT2.0", problem);
    }
  }

  @Test
  void compressedFileIsRejectedWithItsDecompressor() throws IOException {
    ByteArrayOutputStream compressed = new ByteArrayOutputStream();
    try (GZIPOutputStream out = new GZIPOutputStream(compressed)) {
      out.write("#!AER-DAT2.0\n\0\0\0\0\0\0\0\7".getBytes(StandardCharsets.ISO_8859_1));
    }
    assertSays(
        "decompress it first: gunzip",
        refused(Files.write(folder.resolve("a.aedat.gz"), compressed.toByteArray())));
    assertSays(
        "decompress it first: zstd -d",
        refused(Files.write(folder.resolve("a.db3.zstd"), Zstd.compress(PNG))));
  }

  @Test
  void textNamedLikeARecordingIsRejected() throws IOException {
    String text = "# Notes of Monday\nThe fly flew, and then it did not fly any more.\n".repeat(50);
    for (String name : new String[] {"notes.aedat", "notes.dat", "notes.txt"}) {
      assertSays("no known format", refused(Files.writeString(folder.resolve(name), text)));
    }
  }

  @Test
  void randomAndConstantBytesAreRejected() throws IOException {
    byte[] random = new byte[10_000];
    new java.util.Random(5).nextBytes(random);
    assertSays("no known format", refused(Files.write(folder.resolve("random.dat"), random)));
    assertSays(
        "no known format", refused(Files.write(folder.resolve("zero.dat"), new byte[10_000])));
  }

  @Test
  void unknownFormatsAreRejectedWithTheListOfFormats() throws IOException {
    Path file = Files.writeString(folder.resolve("a.aedat"), "#!AER-DAT2.0\n");
    RecordingProblem problem =
        assertThrows(
            RecordingProblem.class,
            () -> Recordings.open(file, ReadOptions.DEFAULT.withFormat("evt9")));
    assertSays("there is no format named evt9", problem);
    assertSays("aedat1, aedat2, aedat3, aedat4, csv", problem);
  }

  @Test
  void recordingWithAnotherExtensionIsRead() throws IOException {
    byte[] bytes = "#!AER-DAT2.0\n\0\0\0\0\0\0\0\7".getBytes(StandardCharsets.ISO_8859_1);
    try (RecordingReader reader = Recordings.open(Files.write(folder.resolve("a.png"), bytes))) {
      assertEquals("aedat2", reader.formatName());
      assertEquals(1, RecordingSummary.scan(reader, ProgressListener.NONE).events());
    }
  }
}
