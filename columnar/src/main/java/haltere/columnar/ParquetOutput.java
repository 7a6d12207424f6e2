package haltere.columnar;

import haltere.core.format.AtomicFile;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import org.apache.parquet.io.OutputFile;
import org.apache.parquet.io.PositionOutputStream;

/** Output of Parquet to an atomic file, which appears complete or not at all. */
final class ParquetOutput implements OutputFile {
  private final AtomicFile file;
  private boolean discarded;

  ParquetOutput(AtomicFile file) {
    this.file = file;
  }

  /** Discards all further bytes. */
  void discard() {
    discarded = true;
  }

  @Override
  public PositionOutputStream create(long blockSizeHint) {
    OutputStream out = new BufferedOutputStream(file.stream(), 1 << 16);
    return new PositionOutputStream() {
      private long position;

      @Override
      public long getPos() {
        return position;
      }

      @Override
      public void write(int value) throws IOException {
        position++;
        if (!discarded) {
          out.write(value);
        }
      }

      @Override
      public void write(byte[] bytes, int from, int count) throws IOException {
        position += count;
        if (!discarded) {
          out.write(bytes, from, count);
        }
      }

      @Override
      public void flush() throws IOException {
        if (!discarded) {
          out.flush();
        }
      }

      @Override
      public void close() throws IOException {
        flush();
      }
    };
  }

  @Override
  public PositionOutputStream createOrOverwrite(long blockSizeHint) {
    return create(blockSizeHint);
  }

  @Override
  public boolean supportsBlockSize() {
    return false;
  }

  @Override
  public long defaultBlockSize() {
    return 0;
  }

  @Override
  public String getPath() {
    return file.path().toString();
  }
}
