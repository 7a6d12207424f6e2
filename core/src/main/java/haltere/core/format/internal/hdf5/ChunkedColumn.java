package haltere.core.format.internal.hdf5;

import haltere.core.format.AtomicFile;
import haltere.core.format.internal.compression.LittleEndian;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.zip.Deflater;

/**
 * Writes a list of numbers or of rows of a table: chunks of rows, optionally compressed, and the
 * tree of their positions.
 *
 * <p>Thread rule: one thread.
 */
final class ChunkedColumn {
  /** Rows of a chunk, unless the column has fewer. */
  static final int CHUNK_ROWS = 1 << 16;

  /** Half of the capacity of a tree node, as all readers expect. */
  private static final int HALF_NODE = 32;

  private static final int NODE_ENTRIES = 2 * HALF_NODE;
  private static final int KEY_BYTES = 24;
  private static final int NODE_HEAD = 24;
  private static final int NODE_BYTES =
      NODE_HEAD + NODE_ENTRIES * 8 + (NODE_ENTRIES + 1) * KEY_BYTES;

  private final String name;
  private final ElementType type;
  private final int size;
  private final int level;
  private final Deflater deflater;
  private final byte[] chunk;
  private final byte[] sorted;
  private byte[] compressed;
  private int compressedBytes;
  private final byte[] evenRow;

  /** Uncompressed bytes of the last chunk if all its rows were {@link #evenRow}, else 0. */
  private int evenBytes;

  private final ByteBuffer chunkBuffer;
  private int chunkRows = CHUNK_ROWS;
  private int filled;
  private long rows;

  /** Position and compressed bytes of each chunk, in pairs. */
  private long[] chunks = new long[16];

  private int chunkCount;

  /**
   * A column without rows.
   *
   * @param name of it in its group
   * @param type of its elements
   * @param level of deflate, 0 for uncompressed chunks
   */
  ChunkedColumn(String name, ElementType type, int level) {
    this.name = name;
    this.type = type;
    size = type.bytes();
    this.level = level;
    chunk = new byte[CHUNK_ROWS * size];
    chunkBuffer = ByteBuffer.wrap(chunk);
    sorted = level > 0 && size > 1 ? new byte[chunk.length] : chunk;
    compressed = level > 0 ? new byte[chunk.length + chunk.length / 8 + 64] : chunk;
    evenRow = new byte[size];
    deflater = level > 0 ? new Deflater(level) : null;
  }

  String name() {
    return name;
  }

  ElementType type() {
    return type;
  }

  int level() {
    return level;
  }

  long rows() {
    return rows;
  }

  int chunkRows() {
    return chunkRows;
  }

  /** The rows not yet written. */
  byte[] chunk() {
    return chunk;
  }

  /** Number of rows not yet written. */
  int filled() {
    return filled;
  }

  /** Sets the number of rows in {@link #chunk()}, and writes a full chunk. */
  void setFilled(int count, AtomicFile file) throws IOException {
    rows += count - filled;
    filled = count;
    if (filled == CHUNK_ROWS) {
      flush(file);
    }
  }

  /** Appends a number of eight bytes. */
  void append(long value, AtomicFile file) throws IOException {
    LittleEndian.putLong(chunk, 8 * filled, value);
    setFilled(filled + 1, file);
  }

  /** Writes the rows that are not yet written, the last ones. */
  void end(AtomicFile file) throws IOException {
    if (filled > 0 && chunkCount == 0) {
      chunkRows = filled;
    }
    flush(file);
  }

  private void flush(AtomicFile file) throws IOException {
    if (filled == 0) {
      return;
    }
    int length = chunkRows * size;
    Arrays.fill(chunk, filled * size, length, (byte) 0);
    if (2 * chunkCount == chunks.length) {
      chunks = Arrays.copyOf(chunks, 2 * chunks.length);
    }
    ByteBuffer bytes = deflater == null ? chunkBuffer.clear().limit(length) : pack(length);
    chunks[2 * chunkCount] = file.channel().position();
    chunks[2 * chunkCount + 1] = bytes.remaining();
    file.write(bytes);
    chunkCount++;
    filled = 0;
  }

  private ByteBuffer pack(int bytes) {
    // without events, all rows of successive index chunks are equal
    boolean even = Arrays.equals(chunk, 0, bytes - size, chunk, size, bytes);
    if (even && bytes == evenBytes && Arrays.equals(chunk, 0, size, evenRow, 0, size)) {
      return ByteBuffer.wrap(compressed, 0, compressedBytes);
    }
    evenBytes = even ? bytes : 0;
    System.arraycopy(chunk, 0, evenRow, 0, size);
    if (sorted != chunk) {
      ByteShuffle.apply(chunk, sorted, bytes, size);
    }
    deflater.reset();
    deflater.setInput(sorted, 0, bytes);
    deflater.finish();
    int length = 0;
    while (!deflater.finished()) {
      if (length == compressed.length) {
        compressed = Arrays.copyOf(compressed, 2 * length);
      }
      length += deflater.deflate(compressed, length, compressed.length - length);
    }
    compressedBytes = length;
    return ByteBuffer.wrap(compressed, 0, length);
  }

  /** Writes the tree of chunks; returns the position of its root, or none without chunks. */
  long writeTree(AtomicFile file) throws IOException {
    if (chunkCount == 0) {
      return ContainerFile.NOWHERE;
    }
    long[] children = new long[chunkCount];
    int[] first = new int[chunkCount];
    for (int i = 0; i < chunkCount; i++) {
      children[i] = chunks[2 * i];
      first[i] = i;
    }
    int nodeLevel = 0;
    do {
      int nodes = (children.length + NODE_ENTRIES - 1) / NODE_ENTRIES;
      long start = file.channel().position();
      long[] above = new long[nodes];
      int[] aboveFirst = new int[nodes];
      for (int node = 0; node < nodes; node++) {
        int from = node * NODE_ENTRIES;
        int to = Math.min(children.length, from + NODE_ENTRIES);
        above[node] = start + (long) node * NODE_BYTES;
        aboveFirst[node] = first[from];
        long left = node == 0 ? -1 : above[node] - NODE_BYTES;
        long right = node == nodes - 1 ? -1 : above[node] + NODE_BYTES;
        file.write(node(nodeLevel, left, right, children, first, from, to));
      }
      children = above;
      first = aboveFirst;
      nodeLevel++;
    } while (children.length > 1);
    return children[0];
  }

  private ByteBuffer node(
      int nodeLevel, long left, long right, long[] children, int[] first, int from, int to) {
    Hdf5Bytes node = new Hdf5Bytes(NODE_BYTES);
    node.text("TREE").u1(1).u1(nodeLevel).u2(to - from).u8(left).u8(right);
    for (int i = from; i < to; i++) {
      key(node, first[i]);
      node.u8(children[i]);
    }
    key(node, to < first.length ? first[to] : chunkCount);
    return node.whole();
  }

  private void key(Hdf5Bytes node, int chunkNumber) {
    node.u4(chunkNumber < chunkCount ? chunks[2 * chunkNumber + 1] : 0).u4(0);
    node.u8((long) chunkNumber * chunkRows).u8(0);
  }

  void close() {
    if (deflater != null) {
      deflater.end();
    }
  }
}
