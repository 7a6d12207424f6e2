package haltere.core.format.internal.hdf5;

import java.io.IOException;

/** The index of most files: a tree whose leaves list chunks by their first row and column. */
final class ChunkTree extends ChunkIndex {
  private static final int MAX_DEPTH = 32;

  private final ContainerFile file;
  private final Dataset dataset;
  private final int dimensions;
  private final int leadingBytes;

  /** First column of the chunks of the stripe. */
  private final long column;

  /** Entries of the leaf read last: row or -1, position, size, filters of each chunk. */
  private long[] leaf = {};

  private int leafChunks;

  ChunkTree(ContainerFile file, Dataset dataset) {
    this.file = file;
    this.dataset = dataset;
    dimensions = dataset.dimensions().length;
    leadingBytes = 8 * dataset.index().leading();
    column = (long) dataset.stripe().number() * dataset.columnsTogether();
  }

  @Override
  boolean find(long chunk) throws IOException {
    long row = chunk * dataset.chunkRows();
    if (inLeaf(row)) {
      return true;
    }
    long position = dataset.position();
    int above = MAX_DEPTH;
    while (position != ContainerFile.NOWHERE) {
      Metadata head = file.at(position, 8 + 2L * file.offsetBytes());
      head.expect("TREE");
      int kind = head.u1();
      int level = head.u1();
      int used = head.u2();
      if (kind != 1 || level >= above) {
        throw head.problem("an index of chunks that does not end");
      }
      above = level;
      int keyBytes = 8 + leadingBytes + 8 * (dimensions + 1);
      Metadata entries =
          file.at(
              position + 8 + 2L * file.offsetBytes(),
              (long) used * (keyBytes + file.offsetBytes()));
      if (level == 0) {
        readLeaf(entries, used);
        return inLeaf(row);
      }
      position = child(entries, used, row);
    }
    return false;
  }

  /** The last child that starts at or before a row of the stripe. */
  private long child(Metadata entries, int used, long row) throws IOException {
    long found = ContainerFile.NOWHERE;
    for (int i = 0; i < used; i++) {
      entries.skip(8L + leadingBytes);
      long first = entries.number(8);
      long firstColumn = column(entries);
      long position = entries.position();
      if (first > row || first == row && firstColumn > column) {
        break;
      }
      found = position;
    }
    return found;
  }

  /** Reads the other numbers of a key: the column in a table, 0 in a list. */
  private long column(Metadata entries) throws IOException {
    long first = entries.number(8);
    entries.skip(8L * (dimensions - 1));
    return first;
  }

  private void readLeaf(Metadata entries, int used) throws IOException {
    leafChunks = 0;
    leaf = leaf.length < 4 * used ? new long[4 * used] : leaf;
    for (int i = 0; i < used; i++) {
      long size = entries.u4();
      long skipped = entries.u4();
      entries.skip(leadingBytes);
      long row = entries.number(8);
      leaf[4 * i] = column(entries) == column ? row : -1;
      leaf[4 * i + 1] = entries.position();
      leaf[4 * i + 2] = size;
      leaf[4 * i + 3] = skipped;
    }
    leafChunks = used;
  }

  private boolean inLeaf(long row) {
    for (int i = 0; i < leafChunks; i++) {
      if (leaf[4 * i] == row && leaf[4 * i + 1] != ContainerFile.NOWHERE) {
        offset = file.offsetOf(leaf[4 * i + 1]);
        bytes = leaf[4 * i + 2];
        skippedFilters = leaf[4 * i + 3];
        return true;
      }
    }
    return false;
  }
}
