package haltere.columnar;

import haltere.core.format.AtomicFile;
import haltere.core.format.internal.compression.ZstdLibrary;
import haltere.core.sink.RowFields;
import haltere.core.sink.TableMetadata;
import haltere.core.sink.TableSink;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Objects;
import org.apache.hadoop.conf.Configuration;
import org.apache.parquet.conf.ParquetConfiguration;
import org.apache.parquet.conf.PlainParquetConfiguration;
import org.apache.parquet.hadoop.ParquetWriter;
import org.apache.parquet.hadoop.api.WriteSupport;
import org.apache.parquet.hadoop.metadata.CompressionCodecName;
import org.apache.parquet.io.OutputFile;

/**
 * Table in a Parquet file.
 *
 * @param <R> type of the rows
 */
final class ParquetTable<R extends Record> implements TableSink<R> {
  /** Maximum size of a row group in memory, in bytes; small against the heap of a batch worker. */
  private static final long ROW_GROUP_BYTES = 4 << 20;

  private final AtomicFile file;
  private final ParquetOutput output;
  private final ParquetWriter<R> writer;
  private long rows;
  private boolean finished;

  ParquetTable(AtomicFile file, Class<R> type, TableMetadata metadata) throws IOException {
    this.file = Objects.requireNonNull(file, "file");
    ZstdLibrary.load();
    output = new ParquetOutput(file);
    writer =
        new Builder<>(output, new RowWriter<R>(new RowFields(type), metadata))
            .withConf(new PlainParquetConfiguration())
            .withCompressionCodec(CompressionCodecName.ZSTD)
            .withRowGroupSize(ROW_GROUP_BYTES)
            .build();
  }

  /**
   * Builds a Parquet writer of an output file and a row writer.
   *
   * @param <R> type of the rows
   */
  private static final class Builder<R> extends ParquetWriter.Builder<R, Builder<R>> {
    private final WriteSupport<R> rows;

    Builder(OutputFile output, WriteSupport<R> rows) {
      super(output);
      this.rows = rows;
    }

    @Override
    protected Builder<R> self() {
      return this;
    }

    @Override
    @SuppressWarnings("deprecation") // abstract all the same
    protected WriteSupport<R> getWriteSupport(Configuration unused) {
      return rows;
    }

    @Override
    protected WriteSupport<R> getWriteSupport(ParquetConfiguration unused) {
      return rows;
    }
  }

  @Override
  public void accept(R row) {
    Objects.requireNonNull(row, "row");
    try {
      writer.write(row);
      rows++;
    } catch (IOException thrown) {
      throw new UncheckedIOException(thrown);
    }
  }

  @Override
  public long rows() {
    return rows;
  }

  @Override
  public void finish() throws IOException {
    finished = true;
    try {
      writer.close();
    } catch (UncheckedIOException thrown) {
      throw thrown.getCause();
    }
    file.commit();
  }

  @Override
  public void close() throws IOException {
    try (file) {
      if (!finished) {
        finished = true;
        output.discard();
        writer.close(); // releases its buffers
      }
    }
  }
}
