package haltere.core.format.internal.hdf5;

import java.io.IOException;

/**
 * The index of growing datasets in newer files: an array with blocks of doubling size, the first of
 * which are listed in an index block and the others in blocks of their own.
 */
final class GrowingChunkArray extends ChunkArray {
  private int offsetBytes;
  private int firstElements;
  private int smallestBlock;
  private int fewestBlocks;

  GrowingChunkArray(ContainerFile file, Dataset dataset) {
    super(file, dataset);
  }

  @Override
  void readHeader() throws IOException {
    Metadata head = file.at(dataset.position(), 12 + 6L * file.lengthBytes() + file.offsetBytes());
    head.expect("EAHD");
    head.skip(2);
    elementBytes = head.u1();
    int bits = head.u1();
    firstElements = head.u1();
    smallestBlock = head.u1();
    fewestBlocks = head.u1();
    pageBits = head.u1();
    head.skip(6L * file.lengthBytes());
    block = head.position();
    offsetBytes = (bits + 7) / 8;
    check(head, Integer.bitCount(smallestBlock) == 1 && Integer.bitCount(fewestBlocks) == 1);
  }

  @Override
  boolean findInBlock(long chunk) throws IOException {
    long prefix = block + 6 + file.offsetBytes();
    if (chunk < firstElements) {
      return element(prefix + chunk * elementBytes);
    }
    return inBlocks(chunk - firstElements, prefix + (long) firstElements * elementBytes);
  }

  /** Blocks form groups; group g has 2^(g/2) blocks of 2^((g+1)/2) times the smallest. */
  private boolean inBlocks(long element, long listed) throws IOException {
    int group = 63 - Long.numberOfLeadingZeros(element / smallestBlock + 1);
    long inGroup = element - ((1L << group) - 1) * smallestBlock;
    long blockElements = (1L << (group + 1) / 2) * smallestBlock;
    long blocksInGroup = 1L << group / 2;
    int groupsListed = 2 * Integer.numberOfTrailingZeros(fewestBlocks);
    long blockInGroup = inGroup / blockElements;
    long pages = blockElements >>> pageBits;
    boolean paged = pages > 1;
    long listing;
    if (group < groupsListed) {
      long before = 0;
      for (int g = 0; g < group; g++) {
        before += 1L << g / 2;
      }
      listing = listed + (before + blockInGroup) * file.offsetBytes();
    } else {
      long blocksListed = 2L * (fewestBlocks - 1);
      long positions = listed + (blocksListed + group - groupsListed) * file.offsetBytes();
      long groupBlock = file.at(positions, file.offsetBytes()).position();
      if (groupBlock == ContainerFile.NOWHERE) {
        return false;
      }
      long bits = paged ? blocksInGroup * ((pages + 7) / 8) : 0;
      listing =
          groupBlock
              + 6
              + file.offsetBytes()
              + offsetBytes
              + bits
              + blockInGroup * file.offsetBytes();
    }
    long dataBlock = file.at(listing, file.offsetBytes()).position();
    if (dataBlock == ContainerFile.NOWHERE) {
      return false;
    }
    long inBlock = inGroup % blockElements;
    long start = dataBlock + 6 + file.offsetBytes() + offsetBytes + (paged ? CHECKSUM : 0);
    long checksums = paged ? (inBlock >>> pageBits) * CHECKSUM : 0;
    return element(start + inBlock * elementBytes + checksums);
  }
}
