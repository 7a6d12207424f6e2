package haltere.core.format.internal.hdf5;

import java.io.IOException;

/** The index of datasets of fixed size in newer files: a paged array. */
final class FixedChunkArray extends ChunkArray {
  private long elements;

  FixedChunkArray(ContainerFile file, Dataset dataset) {
    super(file, dataset);
  }

  @Override
  void readHeader() throws IOException {
    Metadata head = file.at(dataset.position(), 8 + file.lengthBytes() + file.offsetBytes());
    head.expect("FAHD");
    head.skip(2);
    elementBytes = head.u1();
    pageBits = head.u1();
    elements = head.length();
    block = head.position();
    check(head, true);
  }

  @Override
  boolean findInBlock(long chunk) throws IOException {
    if (chunk >= elements) {
      return false;
    }
    long prefix = 6L + file.offsetBytes();
    long pageElements = 1L << pageBits;
    if (elements <= pageElements) {
      return element(block + prefix + chunk * elementBytes);
    }
    long pages = (elements + pageElements - 1) >>> pageBits;
    long page = chunk >>> pageBits;
    Metadata bits = file.at(block + prefix + page / 8, 1);
    if ((bits.u1() & 0x80 >> (int) (page % 8)) == 0) {
      return false;
    }
    long start =
        block
            + prefix
            + (pages + 7) / 8
            + CHECKSUM
            + page * (pageElements * elementBytes + CHECKSUM);
    return element(start + (chunk & pageElements - 1) * elementBytes);
  }
}
