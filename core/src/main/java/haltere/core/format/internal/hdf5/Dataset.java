package haltere.core.format.internal.hdf5;

import haltere.core.format.RecordingProblem;
import java.io.IOException;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Optional;

/**
 * A dataset that is a list of elements, or a table whose rows are read as elements: position and
 * type of its bytes.
 *
 * @param name its path in the file
 * @param type of an element
 * @param dimensions lengths as claimed; none for a single value
 * @param kind layout of the bytes
 * @param position of the bytes, or of the index of the chunks
 * @param bytes claimed size of contiguous data
 * @param inHeader bytes in the header itself
 * @param rowBytes size of a row of a chunk; that of an element except for tables
 * @param chunkRows rows in a chunk
 * @param stripe columns of a table in its chunks
 * @param index parameters of the index of the chunks
 * @param filters steps of the compression of chunks
 */
record Dataset(
    String name,
    ElementType type,
    long[] dimensions,
    StorageLayout kind,
    long position,
    long bytes,
    byte[] inHeader,
    int rowBytes,
    long chunkRows,
    Stripe stripe,
    Index index,
    List<FilterStep> filters) {
  private static final long MAX_CHUNK_BYTES = 0xffffffffL;
  private static final int MAX_TABLE_COLUMNS = 16;
  private static final byte[] NONE = {};

  /** Largest memory for decompressed chunks and their decompression. */
  private static final long MEMORY_BYTES = 28L << 20;

  private static final int UNPACKING = 3;

  /** Layout of the bytes of a dataset. */
  enum StorageLayout {
    /** In its header. */
    IN_HEADER,
    /** Contiguous. */
    RUN,
    /** In one chunk. */
    SINGLE_CHUNK,
    /** In contiguous chunks. */
    IMPLICIT_CHUNKS,
    /** In chunks that are listed in an array. */
    ARRAY_OF_CHUNKS,
    /** In chunks that are listed in an array that can grow. */
    GROWING_ARRAY_OF_CHUNKS,
    /** In chunks that are listed in a tree. */
    TREE_OF_CHUNKS
  }

  /**
   * Columns of a table that are stored in chunks of their own.
   *
   * @param number of the stripe, from 0
   * @param count of stripes
   */
  record Stripe(int number, int count) {
    /** All columns. */
    static final Stripe ALL = new Stripe(0, 1);
  }

  /**
   * Compressed size and skipped filters of a single chunk; else parameters of the index.
   *
   * @param leading dimensions of one element before that of the rows, in the keys of a tree
   * @param size compressed bytes of a single chunk
   * @param skipped filters that a single chunk skips
   */
  record Index(int leading, long size, long skipped) {}

  /** Reads the header of a dataset. */
  static Dataset read(ContainerFile file, String name, ObjectHeader header) throws IOException {
    Metadata typeBody = header.one(ObjectHeader.DATATYPE).orElseThrow(() -> lacks(file, name));
    ElementType type = ElementType.read(typeBody);
    long[] dimensions =
        Dataspace.read(header.one(ObjectHeader.DATASPACE).orElseThrow(() -> lacks(file, name)));
    int leading = isListOfOneRow(dimensions) ? 1 : 0;
    dimensions = Arrays.copyOfRange(dimensions, leading, dimensions.length);
    Metadata layout = header.one(ObjectHeader.LAYOUT).orElseThrow(() -> lacks(file, name));
    if (header.has(ObjectHeader.EXTERNAL_FILES)) {
      throw layout.unknown("a dataset that lies in other files (" + name + ")");
    }
    List<FilterStep> filters =
        header.has(ObjectHeader.FILTERS)
            ? FilterStep.read(header.one(ObjectHeader.FILTERS).orElseThrow())
            : List.of();
    int version = layout.u1();
    if (version < 3 || version > 5) {
      throw layout.unknown("version " + version + " of the layout of " + name);
    }
    int kind = layout.u1();
    Dataset dataset =
        new Dataset(
            name,
            type,
            dimensions,
            null,
            0,
            0,
            NONE,
            0,
            0,
            Stripe.ALL,
            new Index(leading, 0, 0),
            filters);
    return switch (kind) {
      case 0 -> dataset.inHeader(layout);
      case 1 -> {
        long position = layout.position();
        yield dataset.with(
            StorageLayout.RUN, position, layout.length(), NONE, dataset.elementsBytes(), 0);
      }
      case 2 -> version == 3 ? dataset.tree(layout) : dataset.chunks(layout, file);
      default -> throw layout.unknown("a dataset that is put together from others (" + name + ")");
    };
  }

  /** Whether it is a list as MATLAB writes a column. */
  private static boolean isListOfOneRow(long... dimensions) {
    return dimensions.length == 2 && dimensions[0] == 1 && dimensions[1] > MAX_TABLE_COLUMNS;
  }

  private static RecordingProblem lacks(ContainerFile file, String name) {
    return new RecordingProblem(
        file.bytes().path(), "damaged: " + name + " lacks what every dataset has");
  }

  private Dataset with(
      StorageLayout newKind,
      long newPlace,
      long newBytes,
      byte[] content,
      int row,
      long rowsInChunk) {
    return new Dataset(
        name,
        type,
        dimensions,
        newKind,
        newPlace,
        newBytes,
        content,
        row,
        rowsInChunk,
        stripe,
        index,
        filters);
  }

  private Dataset with(Stripe newStripe, Index newIndex) {
    return new Dataset(
        name,
        type,
        dimensions,
        kind,
        position,
        bytes,
        inHeader,
        rowBytes,
        chunkRows,
        newStripe,
        newIndex,
        filters);
  }

  /** Number of columns that are stored together. */
  int columnsTogether() {
    return rowBytes / type.bytes();
  }

  /** The dataset with the chunks of a column. */
  Dataset ofColumn(int column) {
    return with(new Stripe(column / columnsTogether(), stripe.count()), index);
  }

  /** Bytes of a row of one or more elements. */
  private int elementsBytes() {
    return dimensions.length == 2 && dimensions[1] > 0 && dimensions[1] <= MAX_TABLE_COLUMNS
        ? (int) dimensions[1] * type.bytes()
        : type.bytes();
  }

  private Dataset inHeader(Metadata layout) throws IOException {
    byte[] content = layout.bytes(layout.u2());
    return with(
        StorageLayout.IN_HEADER,
        layout.offset() - content.length,
        content.length,
        content,
        elementsBytes(),
        0);
  }

  private Dataset tree(Metadata layout) throws IOException {
    int rank = layout.u1();
    long position = layout.position();
    long[] lengths = new long[Math.max(1, rank)];
    for (int i = 0; i < rank; i++) {
      lengths[i] = layout.u4();
    }
    return chunked(layout, StorageLayout.TREE_OF_CHUNKS, position, lengths, rank);
  }

  private Dataset chunked(
      Metadata layout, StorageLayout newKind, long newPlace, long[] allLengths, int allRank)
      throws IOException {
    int leading = index.leading();
    int rank = allRank - leading;
    long[] lengths = Arrays.copyOfRange(allLengths, leading, allLengths.length);
    if (leading > 0 && allLengths[0] != 1) {
      throw layout.unknown("a list in chunks of several rows (" + name + ")");
    }
    if (rank != dimensions.length + 1 || rank < 2) {
      throw layout.problem("chunks of " + (rank - 1) + " dimensions in " + name);
    }
    long row = type.bytes();
    int stripes = 1;
    if (rank == 3 && lengths[1] >= 1 && Math.max(lengths[1], dimensions[1]) <= MAX_TABLE_COLUMNS) {
      row = lengths[1] * type.bytes();
      stripes = (int) ((dimensions[1] + lengths[1] - 1) / lengths[1]);
    } else if (rank != 2) {
      throw layout.unknown("a table of more than " + MAX_TABLE_COLUMNS + " columns (" + name + ")");
    }
    if (lengths[0] < 1 || lengths[0] > MAX_CHUNK_BYTES / Math.max(1, row)) {
      throw layout.problem("chunks of " + lengths[0] + " rows in " + name);
    }
    return with(newKind, newPlace, 0, NONE, (int) row, lengths[0])
        .with(new Stripe(0, Math.max(1, stripes)), index);
  }

  private Dataset chunks(Metadata layout, ContainerFile file) throws IOException {
    int flags = layout.u1();
    int rank = layout.u1();
    int size = layout.u1();
    if (size < 1 || size > 8) {
      throw layout.problem("lengths of " + size + " bytes");
    }
    long[] lengths = new long[Math.max(1, rank)];
    for (int i = 0; i < rank; i++) {
      lengths[i] = layout.number(size);
    }
    int indexKind = layout.u1();
    Index newIndex = index;
    StorageLayout newKind;
    switch (indexKind) {
      case 1 -> {
        newKind = StorageLayout.SINGLE_CHUNK;
        if ((flags & 2) != 0) {
          long compressed = layout.length();
          newIndex = new Index(index.leading(), compressed, layout.u4());
        }
      }
      case 2 -> newKind = StorageLayout.IMPLICIT_CHUNKS;
      case 3 -> {
        newKind = StorageLayout.ARRAY_OF_CHUNKS;
        layout.skip(1);
      }
      case 4 -> {
        newKind = StorageLayout.GROWING_ARRAY_OF_CHUNKS;
        layout.skip(5);
      }
      default -> throw layout.unknown("a table that can grow both ways (" + name + ")");
    }
    Dataset found = chunked(layout, newKind, layout.position(), lengths, rank);
    return found.with(found.stripe, newIndex);
  }

  /** Claimed number of rows. */
  long rows() {
    return dimensions.length == 0 ? 1 : dimensions[0];
  }

  /** Whether it is a list of elements, or a table of one column. */
  boolean isList() {
    return dimensions.length == 1 || dimensions.length == 2 && dimensions[1] == 1;
  }

  /** Columns of a table; 0 if it is not a table. */
  int columns() {
    return dimensions.length == 2 && dimensions[1] <= MAX_TABLE_COLUMNS ? (int) dimensions[1] : 0;
  }

  boolean isChunked() {
    return kind != StorageLayout.RUN && kind != StorageLayout.IN_HEADER;
  }

  /** Number of a chunk of the stripe among those of all, which lie side by side. */
  long chunkNumber(long chunkOfRows) {
    return chunkOfRows * stripe.count() + stripe.number();
  }

  /** Bytes of a decompressed chunk. */
  long chunkBytes() {
    return chunkRows * rowBytes;
  }

  /** Rejects datasets that cannot be read, or not within bounded memory. */
  static void check(ContainerFile container, Collection<Dataset> datasets) throws RecordingProblem {
    long decompressed = 0;
    long largest = 0;
    for (Dataset dataset : datasets) {
      for (FilterStep step : dataset.filters) {
        Optional<String> obstacle = step.obstacle(dataset.type().bytes());
        if (obstacle.isPresent()) {
          throw new RecordingProblem(
              container.bytes().path(), dataset.name() + " is compressed with " + obstacle.get());
        }
      }
      if (dataset.isChunked() && !dataset.filters.isEmpty()) {
        decompressed += dataset.chunkBytes();
        largest = Math.max(largest, dataset.chunkBytes());
      }
    }
    if (decompressed + UNPACKING * largest > MEMORY_BYTES) {
      throw new RecordingProblem(
          container.bytes().path(),
          "its data are compressed in chunks of up to "
              + (largest >> 10)
              + " KiB, too large for a reader with bounded memory; rewrite it with smaller "
              + "ones, such as h5repack -l CHUNK=65536");
    }
  }
}
