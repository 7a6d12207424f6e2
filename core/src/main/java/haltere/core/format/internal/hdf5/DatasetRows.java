package haltere.core.format.internal.hdf5;

import haltere.core.format.RecordingFile;
import haltere.core.format.internal.compression.DamagedPacketException;
import java.io.IOException;
import java.nio.ByteBuffer;

/**
 * The rows of a dataset, a part of them in memory at a time: a chunk if chunks are compressed, else
 * a piece of the file.
 *
 * <p>Thread rule: one thread.
 */
final class DatasetRows {
  private static final int PIECE_BYTES = 256 * 1024;

  private final Dataset dataset;
  private final RecordingFile file;
  private final ContainerFile container;
  private final ChunkDecompressor decompressor;
  private final ChunkIndex index;
  private final int rowBytes;
  private byte[] data = {};
  private byte[] compressed = {};
  private long start;
  private long end;

  /** The chunk found last, so that pieces of it need no second search. */
  private long chunk = -1;

  private boolean chunkFound;

  DatasetRows(ContainerFile container, Dataset dataset, ChunkDecompressor decompressor) {
    this.container = container;
    this.dataset = dataset;
    this.decompressor = decompressor;
    file = container.bytes();
    index = dataset.isChunked() ? ChunkIndex.of(container, dataset) : null;
    rowBytes = dataset.rowBytes();
  }

  /**
   * Loads a row, and the following ones of its chunk.
   *
   * @param row the row
   * @return number of rows from that one on; 0 at the end of the file
   * @throws DamagedPacketException if they exist, but cannot be decompressed
   * @throws IOException if the file can no longer be read, or the list of chunks is damaged
   */
  long load(long row) throws IOException, DamagedPacketException {
    if (row >= start && row < end) {
      return end - row;
    }
    start = row;
    end = row;
    if (row >= dataset.rows()) {
      return 0;
    }
    switch (dataset.kind()) {
      case IN_HEADER -> {
        start = 0;
        data = dataset.inHeader();
        end = data.length / rowBytes;
      }
      case RUN -> {
        if (dataset.position() != ContainerFile.NOWHERE) {
          piece(row, container.offsetOf(dataset.position()) + row * rowBytes, Long.MAX_VALUE);
        }
      }
      default -> loadChunk(row);
    }
    end = Math.max(start, Math.min(end, dataset.rows()));
    return Math.max(0, end - row);
  }

  private void loadChunk(long row) throws IOException, DamagedPacketException {
    long wanted = row / dataset.chunkRows();
    if (wanted != chunk) {
      chunkFound = index.find(wanted);
      chunk = wanted;
    }
    if (!chunkFound || index.offset() >= file.size()) {
      return;
    }
    long first = wanted * dataset.chunkRows();
    if (dataset.filters().isEmpty()) {
      long inChunk = row - first;
      piece(row, index.offset() + inChunk * rowBytes, dataset.chunkRows() - inChunk);
      return;
    }
    int bytes = (int) dataset.chunkBytes();
    if (index.bytes() > bytes + bytes / 8 + 4096L) {
      throw new DamagedPacketException("a chunk of " + index.bytes() + " compressed bytes");
    }
    int length = (int) index.bytes();
    if (compressed.length < length) {
      compressed = new byte[length + length / 4];
    }
    if (data.length < bytes) {
      data = new byte[bytes];
    }
    if (read(compressed, length, index.offset()) < length) {
      return;
    }
    int unpacked =
        decompressor.unpack(
            dataset.filters(), index.skippedFilters(), compressed, length, data, bytes);
    start = first;
    end = first + unpacked / rowBytes;
    if (row >= end) {
      throw new DamagedPacketException("a chunk of too few rows");
    }
  }

  /** Reads uncompressed rows, up to a number. */
  private void piece(long row, long offset, long maxRows) throws IOException {
    if (offset < 0 || rowBytes < 1) {
      return;
    }
    int rows = (int) Math.min(maxRows, Math.max(1, PIECE_BYTES / rowBytes));
    rows = (int) Math.min(rows, dataset.rows() - row);
    if (data.length < rows * rowBytes) {
      data = new byte[rows * rowBytes];
    }
    end = row + read(data, rows * rowBytes, offset) / rowBytes;
  }

  private int read(byte[] target, int length, long offset) throws IOException {
    ByteBuffer buffer = ByteBuffer.wrap(target, 0, length).slice();
    file.read(buffer, offset);
    return buffer.limit();
  }

  /** The loaded rows; replaced by each {@link #load}. */
  byte[] data() {
    return data;
  }

  /** Index in {@link #data()} of a loaded row. */
  int at(long row) {
    return (int) ((row - start) * rowBytes);
  }

  /** The first row after the chunk of a row, to continue after damage. */
  long behindChunk(long row) {
    return dataset.isChunked()
        ? (row / dataset.chunkRows() + 1) * dataset.chunkRows()
        : dataset.rows();
  }

  /** File offset of a row, or of its chunk if that is compressed. */
  long offset(long row) {
    long offset =
        switch (dataset.kind()) {
          case IN_HEADER -> dataset.position() + row * rowBytes;
          case RUN -> container.offsetOf(Math.max(0, dataset.position())) + row * rowBytes;
          default ->
              dataset.filters().isEmpty()
                  ? index.offset() + row % dataset.chunkRows() * rowBytes
                  : index.offset();
        };
    return Math.max(0, Math.min(file.size(), offset));
  }
}
