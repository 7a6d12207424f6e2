package haltere.columnar;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.format.AtomicFile;
import haltere.core.format.RecordingProblem;
import haltere.core.sink.Column;
import haltere.core.sink.CsvSink;
import haltere.core.sink.TableMetadata;
import haltere.core.sink.TableSink;
import haltere.core.sink.Tables;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.stream.Stream;
import org.apache.parquet.schema.PrimitiveType.PrimitiveTypeName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ParquetTableTest {
  @TempDir Path folder;

  enum Side {
    LEFT;

    @Override
    public String toString() {
      return "left";
    }
  }

  record Row(
      long tUs,
      int id,
      Side side,
      @Column(decimals = 1) double angleRad,
      float levelPx,
      boolean seen,
      OptionalInt lane,
      @Column("speed_m_s") OptionalDouble speedMS,
      String note) {}

  private static final TableMetadata MADE_WITH = () -> Map.of("haltere.program", "haltere test");

  private static Row row(int i) {
    return new Row(
        1_000_000_000_000L + i,
        i,
        Side.LEFT,
        i == 1 ? Double.NaN : Math.sqrt(i),
        i / 4f,
        i % 2 == 0,
        i == 1 ? OptionalInt.empty() : OptionalInt.of(i % 7),
        i == 1 ? OptionalDouble.empty() : OptionalDouble.of(Math.sin(i)),
        i == 1 ? null : "n" + i);
  }

  private Path write(String name, int rows) throws IOException {
    Path file = folder.resolve(name);
    try (TableSink<Row> table = Tables.create(file, Row.class, true, MADE_WITH)) {
      for (int i = 0; i < rows; i++) {
        table.accept(row(i));
      }
      table.finish();
      assertEquals(rows, table.rows());
    }
    return file;
  }

  @Test
  void rowsAreReadBackWithCsvColumnsAndTypes() throws IOException {
    ParquetTables.Content content = ParquetTables.read(write("a.parquet", 3));
    assertEquals(CsvSink.columns(Row.class), content.columns());
    assertEquals(
        List.of(
            PrimitiveTypeName.INT64,
            PrimitiveTypeName.INT32,
            PrimitiveTypeName.BINARY,
            PrimitiveTypeName.DOUBLE,
            PrimitiveTypeName.FLOAT,
            PrimitiveTypeName.BOOLEAN,
            PrimitiveTypeName.INT32,
            PrimitiveTypeName.DOUBLE,
            PrimitiveTypeName.BINARY),
        content.types());
    assertEquals(
        Stream.of(1_000_000_000_002L, 2, "left", Math.sqrt(2), 0.5f, true, 2, Math.sin(2), "n2")
            .toList(),
        content.rows().get(2));
  }

  @Test
  void emptyCsvValuesAreNull() throws IOException {
    List<Object> second = ParquetTables.read(write("a.parquet", 2)).rows().get(1);
    for (int column : new int[] {3, 6, 7, 8}) {
      assertEquals(null, second.get(column));
    }
  }

  @Test
  void metadataContainsUnitsAndProgram() throws IOException {
    Map<String, String> metadata = ParquetTables.read(write("a.parquet", 1)).metadata();
    assertEquals("haltere test", metadata.get("haltere.program"));
    String units = metadata.get("haltere.units");
    assertTrue(units.contains("\"angle_rad\" : \"rad\""), units);
    assertTrue(units.contains("\"speed_m_s\" : \"m/s\""), units);
    assertFalse(units.contains("id"), units);
  }

  @Test
  void sameRowsGiveTheSameBytesAcrossRowGroups() throws IOException {
    Path first = write("a.parquet", 300_000);
    Path second = write("b.parquet", 300_000);
    assertArrayEquals(Files.readAllBytes(first), Files.readAllBytes(second));
    ParquetTables.Content content = ParquetTables.read(first);
    assertTrue(content.rowGroups() > 1);
    assertEquals(300_000, content.rows().size());
    assertEquals(299_999, content.rows().get(299_999).get(1));
  }

  @Test
  void unfinishedTableLeavesNoFile() throws IOException {
    try (TableSink<Row> table =
        Tables.create(folder.resolve("a.parquet"), Row.class, false, MADE_WITH)) {
      table.accept(row(0));
    }
    try (Stream<Path> left = Files.list(folder)) {
      assertEquals(0, left.count());
    }
  }

  @Test
  void existingTableIsNotReplaced() throws IOException {
    Path file = write("a.parquet", 1);
    assertThrows(RecordingProblem.class, () -> Tables.create(file, Row.class, false, MADE_WITH));
  }

  @Test
  void fullDiskIsReportedWithTheFile() {
    OutputStream full =
        new OutputStream() {
          @Override
          public void write(int value) throws IOException {
            throw new IOException("No space left on device");
          }
        };
    Path file = folder.resolve("full.parquet");
    Exception thrown =
        assertThrows(
            Exception.class,
            () -> {
              try (TableSink<Row> table =
                  Tables.of(AtomicFile.on(file, full), Row.class, MADE_WITH)) {
                for (int i = 0; i < 200_000; i++) {
                  table.accept(row(i));
                }
                table.finish();
              }
            });
    Throwable problem = thrown instanceof UncheckedIOException ? thrown.getCause() : thrown;
    assertTrue(problem.getMessage().contains("full.parquet"), problem::toString);
    assertTrue(problem.getMessage().contains("No space left"), problem::toString);
  }

  @Test
  void unreadableMetadataLeavesNoFile() throws IOException {
    Path file = folder.resolve("a.parquet");
    TableMetadata gone =
        () -> {
          throw new IOException("gone");
        };
    try (TableSink<Row> table = Tables.create(file, Row.class, false, gone)) {
      table.accept(row(0));
      assertEquals("gone", assertThrows(IOException.class, table::finish).getMessage());
    }
    assertFalse(Files.exists(file));
  }
}
