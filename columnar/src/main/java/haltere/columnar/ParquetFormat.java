package haltere.columnar;

import haltere.core.format.AtomicFile;
import haltere.core.sink.TableFormat;
import haltere.core.sink.TableMetadata;
import haltere.core.sink.TableSink;
import java.io.IOException;

/**
 * Table format Apache Parquet: the columns of CSV with their types. Integers are INT64 or INT32,
 * floating-point numbers DOUBLE or FLOAT in full precision, booleans BOOLEAN, texts and enum
 * constants STRING. An empty field of CSV is null. The metadata of the file contain the units of
 * the columns ({@code haltere.units}, a JSON object) and the entries of {@link TableMetadata}. The
 * same rows and entries give the same bytes.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
public final class ParquetFormat implements TableFormat {
  /** For the service loader. */
  public ParquetFormat() {}

  @Override
  public String extension() {
    return "parquet";
  }

  @Override
  public <R extends Record> TableSink<R> open(
      AtomicFile file, Class<R> type, TableMetadata metadata) throws IOException {
    try {
      return new ParquetTable<>(file, type, metadata);
    } catch (IOException | RuntimeException | LinkageError problem) {
      file.close();
      throw problem;
    }
  }
}
