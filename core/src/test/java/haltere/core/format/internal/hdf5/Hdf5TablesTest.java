package haltere.core.format.internal.hdf5;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.format.RecordingProblem;
import haltere.core.format.internal.hdf5.Hdf5TableWriter.Hdf5Column;
import haltere.core.format.internal.hdf5.Hdf5TableWriter.NumberType;
import haltere.testing.ReplacedFile;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class Hdf5TablesTest {
  private static final List<Hdf5Column> COLUMNS =
      List.of(
          new Hdf5Column("obj_id", NumberType.U32),
          new Hdf5Column("frame", NumberType.I64),
          new Hdf5Column("x", NumberType.F32),
          new Hdf5Column("timestamp", NumberType.F64));

  @TempDir Path folder;

  private Path written(int rows) throws IOException {
    Path file = folder.resolve("table-" + rows + ".h5");
    try (Hdf5TableWriter writer = Hdf5TableWriter.create(file, "lines", COLUMNS, false)) {
      for (int i = 0; i < rows; i++) {
        writer.append(
            3_000_000_000L + i, -7L * i, i % 3 == 0 ? Double.NaN : 0.1 * i, 1e9 + 1e-3 * i);
      }
      assertEquals(rows, writer.rows());
      assertFalse(Files.exists(file), "it appears when it is finished");
      writer.finish();
    }
    return file;
  }

  @Test
  void tableOfSeveralChunksIsReadBack() throws IOException {
    for (int rows : new int[] {0, 1, 70_000}) {
      Path file = written(rows);
      assertTrue(Hdf5Tables.isHdf5(file));
      try (Hdf5Tables tables = Hdf5Tables.open(file)) {
        assertEquals(Set.of("obj_id", "frame", "x", "timestamp"), tables.columns("lines"));
        assertEquals(Set.of(), tables.columns("others"));
        List<Long> seen = new ArrayList<>();
        tables.read(
            "lines",
            List.of("timestamp", "x", "frame", "obj_id", "none"),
            4,
            row -> {
              int i = (int) row.index();
              assertEquals(1e9 + 1e-3 * i, row.number(0));
              assertEquals(i % 3 == 0 ? Double.NaN : (float) (0.1 * i), row.number(1));
              assertEquals(-7L * i, row.number(2));
              assertEquals(String.valueOf(3_000_000_000L + i), row.text(3));
              assertEquals(Double.NaN, row.number(4));
              assertEquals("", row.text(4));
              seen.add(row.index());
            });
        assertEquals(rows, seen.size());
      }
    }
  }

  @Test
  void groupsOfDatasetsAndCompoundDatasetsAreTables() throws IOException {
    for (String[] place : new String[][] {{"dsec", "events"}, {"prophesee", "CD/events"}}) {
      Path file = folder.resolve(place[0] + ".h5");
      try (InputStream in = Hdf5TablesTest.class.getResourceAsStream(place[0] + ".h5")) {
        Files.copy(in, file);
      }
      try (Hdf5Tables tables = Hdf5Tables.open(file)) {
        assertEquals(Set.of("t", "x", "y", "p"), tables.columns(place[1]));
        long[] rows = new long[1];
        tables.read(
            place[1],
            List.of("x", "y"),
            2,
            row -> {
              assertEquals(row.index() * 31 % 346, row.number(0));
              assertEquals(row.index() * 17 % 260, row.number(1));
              rows[0]++;
            });
        assertEquals(300, rows[0]);
      }
    }
  }

  @Test
  void missingAndMistypedTablesAreReportedWithTheFile() throws IOException {
    Path file = written(3);
    try (Hdf5Tables tables = Hdf5Tables.open(file)) {
      assertRefused(file, "no table others", () -> tables.read("others", List.of("x"), 1, r -> {}));
      assertRefused(file, "no column y", () -> tables.read("lines", List.of("y"), 1, r -> {}));
      assertRefused(
          file, "no lists", () -> tables.read("lines", List.of("x"), 1, row -> row.list(0)));
    }
    Path text = Files.writeString(folder.resolve("text.h5"), "t_us,x\n");
    assertFalse(Hdf5Tables.isHdf5(text));
    assertRefused(text, "not an HDF5 file", () -> Hdf5Tables.open(text).close());
    assertThrows(
        IllegalArgumentException.class,
        () -> Hdf5TableWriter.create(folder.resolve("no.h5"), "lines", List.of(), false));
    assertThrows(IOException.class, () -> Hdf5TableWriter.create(file, "lines", COLUMNS, false));
  }

  private interface Reading {
    void run() throws IOException;
  }

  private static void assertRefused(Path file, String words, Reading reading) {
    RecordingProblem problem = assertThrows(RecordingProblem.class, reading::run);
    assertTrue(problem.getMessage().contains(words), problem.getMessage());
    assertTrue(problem.getMessage().startsWith(file.toString()), problem.getMessage());
  }

  @Test
  void truncatedFilesAreRejectedOrReadCompletely() throws IOException {
    byte[] whole = Files.readAllBytes(written(500));
    int refused = 0;
    for (int length = 0; length < whole.length; length += length < 4096 ? 31 : 997) {
      Path cut = folder.resolve("cut.h5");
      ReplacedFile.write(cut, java.util.Arrays.copyOf(whole, length));
      double[] sum = new double[1];
      try (Hdf5Tables tables = Hdf5Tables.open(cut)) {
        tables.read("lines", List.of("frame"), 1, row -> sum[0] += row.number(0));
        assertEquals(-7.0 * 499 * 500 / 2, sum[0], "cut at " + length);
      } catch (RecordingProblem problem) {
        refused++;
        assertTrue(problem.getMessage().startsWith(cut.toString()), problem.getMessage());
      }
    }
    assertTrue(refused > 130, refused + " refused");
  }
}
