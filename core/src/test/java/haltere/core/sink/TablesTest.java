package haltere.core.sink;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.format.AtomicFile;
import haltere.core.format.RecordingProblem;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class TablesTest {
  @TempDir Path folder;

  record Row(long timeUs, double xPx) {}

  private Path write(String name) throws IOException {
    Path file = folder.resolve(name);
    try (TableSink<Row> table = Tables.create(file, Row.class, false, TableMetadata.NONE)) {
      table.accept(new Row(5, 0.5));
      table.finish();
    }
    return file;
  }

  @Test
  void unknownExtensionsAreCsv() throws IOException {
    for (String name : List.of("a.csv", "a.txt", "a")) {
      assertEquals("time_us,x_px\n5,0.5\n", Files.readString(write(name)));
    }
    assertEquals(List.of("csv"), Tables.extensions());
  }

  @Test
  void formatOfAMissingModuleIsRejectedWithItsName() throws IOException {
    RecordingProblem problem = assertThrows(RecordingProblem.class, () -> write("a.parquet"));
    assertTrue(problem.getMessage().contains("haltere-columnar"), problem.getMessage());
    AtomicFile begun = AtomicFile.create(folder.resolve("b.parquet"), false);
    assertThrows(RecordingProblem.class, () -> Tables.of(begun, Row.class, TableMetadata.NONE));
    try (Stream<Path> left = Files.list(folder)) {
      assertEquals(0, left.count());
    }
  }

  @Test
  void columnNameStatesTheUnit() {
    assertEquals("px/s", ColumnUnit.of("vx_px_s").orElseThrow().symbol());
    assertEquals("rad/s", ColumnUnit.of("p_rad_s").orElseThrow().symbol());
    assertEquals("\u00b5s", ColumnUnit.of("t_us").orElseThrow().symbol());
    assertTrue(ColumnUnit.of("events").isEmpty());
  }
}
