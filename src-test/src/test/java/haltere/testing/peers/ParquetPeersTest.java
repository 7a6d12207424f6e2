package haltere.testing.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.sink.Column;
import haltere.core.sink.TableSink;
import haltere.core.sink.Tables;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * pyarrow and DuckDB read tables in Parquet with their types and metadata. Needs {@link
 * PythonPrograms}; skipped without.
 */
class ParquetPeersTest {
  @TempDir Path folder;
  private PythonPrograms peers;
  private Path file;

  enum Side {
    LEFT,
    RIGHT
  }

  record Row(
      long tUs,
      int id,
      Side side,
      @Column(decimals = 1) double angleRad,
      float levelPx,
      boolean seen,
      OptionalDouble areaPx) {}

  @BeforeEach
  void write() throws IOException {
    peers = PythonPrograms.orSkip("parquet.py", folder);
    file = folder.resolve("a.parquet");
    try (TableSink<Row> table =
        Tables.create(file, Row.class, false, () -> Map.of("haltere.recording", "\u00fc.aedat"))) {
      table.accept(
          new Row(
              1_700_000_000_000_001L, 1, Side.LEFT, 0.123456, 0.5f, true, OptionalDouble.of(2)));
      table.accept(new Row(-5, -1, Side.RIGHT, Double.NaN, -1f, false, OptionalDouble.empty()));
      table.finish();
    }
  }

  @Test
  void columnTypesAndRowsAreReadByPyarrowAndDuckDb() throws IOException {
    List<String> rows =
        List.of(
            "1700000000000001,1,LEFT,0.123456,0.5,True,2.0", "-5,-1,RIGHT,null,-1.0,False,null");
    List<String> read = peers.run("read", file.toString()).orElseThrow();
    assertEquals(
        "pyarrow t_us:int64,id:int32,side:string,angle_rad:double,level_px:float,seen:bool,"
            + "area_px:double",
        read.get(0));
    assertEquals(rows, read.subList(1, 3));
    assertEquals(
        "duckdb t_us:BIGINT,id:INTEGER,side:VARCHAR,angle_rad:DOUBLE,level_px:FLOAT,seen:BOOLEAN,"
            + "area_px:DOUBLE",
        read.get(3));
    assertEquals(rows, read.subList(4, 6));
  }

  @Test
  void metadataHasUnitsAndRecordingName() throws IOException {
    List<String> metadata = peers.run("metadata", file.toString()).orElseThrow();
    assertEquals("haltere.recording \u00fc.aedat", metadata.get(0));
    assertTrue(metadata.get(1).contains("\"t_us\" : \"\u00b5s\""), metadata.get(1));
  }
}
