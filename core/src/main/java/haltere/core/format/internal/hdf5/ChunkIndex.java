package haltere.core.format.internal.hdf5;

import java.io.IOException;

/**
 * Positions of the chunks of a dataset, with only the next ones in memory.
 *
 * <p>Thread rule: one thread.
 */
abstract class ChunkIndex {
  /** File offset of the chunk found last. */
  protected long offset;

  /** Its size in the file in bytes. */
  protected long bytes;

  /** Bit mask of filters not applied to it. */
  protected long skippedFilters;

  static ChunkIndex of(ContainerFile file, Dataset dataset) {
    return switch (dataset.kind()) {
      case TREE_OF_CHUNKS -> new ChunkTree(file, dataset);
      case ARRAY_OF_CHUNKS -> new FixedChunkArray(file, dataset);
      case GROWING_ARRAY_OF_CHUNKS -> new GrowingChunkArray(file, dataset);
      default -> new PlainChunks(file, dataset);
    };
  }

  /**
   * Finds a chunk of the dataset's stripe.
   *
   * @param chunk number of it in the order of rows, from 0
   * @return false if there is none
   * @throws IOException if the index is damaged or the file cannot be read
   */
  abstract boolean find(long chunk) throws IOException;

  long offset() {
    return offset;
  }

  long bytes() {
    return bytes;
  }

  long skippedFilters() {
    return skippedFilters;
  }

  /** A single chunk, or chunks that follow each other. */
  private static final class PlainChunks extends ChunkIndex {
    private final ContainerFile file;
    private final Dataset dataset;

    PlainChunks(ContainerFile file, Dataset dataset) {
      this.file = file;
      this.dataset = dataset;
    }

    @Override
    boolean find(long chunkOfRows) {
      long chunk = dataset.chunkNumber(chunkOfRows);
      boolean single = dataset.kind() == Dataset.StorageLayout.SINGLE_CHUNK;
      if (dataset.position() == ContainerFile.NOWHERE
          || single && chunk > 0
          || chunk > file.bytes().size() / Math.max(1, dataset.chunkBytes())) {
        return false;
      }
      boolean sized = single && dataset.index().size() > 0;
      bytes = sized ? dataset.index().size() : dataset.chunkBytes();
      skippedFilters = dataset.index().skipped();
      offset = file.offsetOf(dataset.position()) + chunk * dataset.chunkBytes();
      return true;
    }
  }
}
