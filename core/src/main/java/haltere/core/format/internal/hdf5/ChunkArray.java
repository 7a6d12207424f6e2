package haltere.core.format.internal.hdf5;

import java.io.IOException;

/** The index of datasets that cannot grow, in files of the newer kind: an array, with pages. */
final class ChunkArray extends ChunkIndex {
  private static final int CHECKSUM = 4;

  private final ContainerFile file;
  private final Dataset dataset;
  private boolean opened;
  private int elementBytes;
  private int pageBits;
  private long elements;
  private long block;

  ChunkArray(ContainerFile file, Dataset dataset) {
    this.file = file;
    this.dataset = dataset;
  }

  private void open() throws IOException {
    Metadata head = file.at(dataset.position(), 8 + file.lengthBytes() + file.offsetBytes());
    head.expect("FAHD");
    head.skip(2);
    elementBytes = head.u1();
    pageBits = head.u1();
    elements = head.length();
    block = head.position();
    if (elementBytes < file.offsetBytes() || pageBits > 31) {
      throw head.problem("an array of chunks that cannot be");
    }
    opened = true;
  }

  @Override
  boolean find(long chunk) throws IOException {
    if (dataset.position() == ContainerFile.NOWHERE) {
      return false;
    }
    if (!opened) {
      open();
    }
    if (chunk >= elements || block == ContainerFile.NOWHERE) {
      return false;
    }
    long prefix = 6L + file.offsetBytes();
    long pageElements = 1L << pageBits;
    if (elements <= pageElements) {
      Metadata at = file.at(block + prefix + chunk * elementBytes, elementBytes);
      return element(file, dataset, at, elementBytes);
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
    Metadata at = file.at(start + (chunk & pageElements - 1) * elementBytes, elementBytes);
    return element(file, dataset, at, elementBytes);
  }
}
