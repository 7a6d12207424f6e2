package haltere.core.format.internal.hdf5;

import java.io.IOException;

/** The index of a dataset in files of the newer kind: an array of chunks with a header. */
abstract class ChunkArray extends ChunkIndex {
  static final int CHECKSUM = 4;

  private static final int MAX_PAGE_BITS = 31;

  final ContainerFile file;
  final Dataset dataset;

  /** Size of an element of the array. */
  int elementBytes;

  /** A page has 2^pageBits elements. */
  int pageBits;

  /** Position of the block that the header states. */
  long block;

  private boolean isOpen;

  ChunkArray(ContainerFile file, Dataset dataset) {
    this.file = file;
    this.dataset = dataset;
  }

  /** Reads the header and checks it by {@link #check}. */
  abstract void readHeader() throws IOException;

  /** Finds a chunk, from 0, in an array that has a block. */
  abstract boolean findInBlock(long chunk) throws IOException;

  @Override
  final boolean find(long chunk) throws IOException {
    if (dataset.position() == ContainerFile.NOWHERE) {
      return false;
    }
    if (!isOpen) {
      readHeader();
      isOpen = true;
    }
    return block != ContainerFile.NOWHERE && chunk >= 0 && findInBlock(dataset.chunkNumber(chunk));
  }

  final void check(Metadata head, boolean isPossible) throws IOException {
    if (!isPossible || elementBytes < file.offsetBytes() || pageBits > MAX_PAGE_BITS) {
      throw head.problem("an array of chunks that cannot be");
    }
  }

  /** Reads the element at a position in the file; false if it states no chunk. */
  final boolean element(long at) throws IOException {
    Metadata element = file.at(at, elementBytes);
    long position = element.position();
    bytes = dataset.chunkBytes();
    skippedFilters = 0;
    int compressedSize = elementBytes - file.offsetBytes() - 4;
    if (compressedSize > 0) {
      bytes = element.number(Math.min(8, compressedSize));
      skippedFilters = element.u4();
    }
    offset = file.offsetOf(position);
    return position != ContainerFile.NOWHERE;
  }
}
