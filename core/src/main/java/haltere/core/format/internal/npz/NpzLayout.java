package haltere.core.format.internal.npz;

import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.internal.decoding.ColumnGuess;
import haltere.core.format.internal.decoding.EventColumn;
import haltere.core.format.internal.decoding.RowCursor;
import haltere.core.format.internal.decoding.Topics;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Columns of the events.
 *
 * @param columns by content; at least times, columns and rows
 * @param topics names of the arrays that hold events on their own, that of the events first
 * @param guessed contents of the columns of a table without names, in their order; else empty
 * @param rows events that all columns claim
 * @param inconsistent whether columns claim different numbers, or more than their file can contain
 * @param cutOff whether the file is truncated
 * @param timeScale power of ten of the times' unit in microseconds
 * @param sensor its size, if the file states it
 * @param origin origin of rows, if the file states it
 */
record NpzLayout(
    Map<EventColumn, ArrayColumn> columns,
    List<String> topics,
    List<EventColumn> guessed,
    long rows,
    boolean inconsistent,
    boolean cutOff,
    int timeScale,
    Optional<SensorGeometry> sensor,
    Optional<Origin> origin) {
  static final String WIDTH = "width";
  static final String HEIGHT = "height";
  static final String ROWS_UP = "rows_up";

  private static final int PROBE_ROWS = 4096;
  private static final int PROBE_BYTES = 1 << 20;

  /** More than any file has. */
  private static final long MAX_ROWS = 1L << 50;

  /**
   * A column.
   *
   * @param array its array
   * @param field its field in an element
   */
  record ArrayColumn(Array array, NpyHeader.NpyField field) {
    /** Offset of its first element in the array. */
    long start() {
      NpyHeader header = array.header();
      long before = header.isByColumns() ? Math.min(header.rows(), MAX_ROWS) : 0;
      return header.dataOffset() + field.offset() * before;
    }

    /** Bytes of an element. */
    int stride() {
      return array.header().isByColumns() ? field.bytes() : array.header().itemBytes();
    }

    /** Offset of the number in an element. */
    int offset() {
      return array.header().isByColumns() ? 0 : field.offset();
    }

    /** Number of its first rows that tell what it is. */
    int probedRows() {
      int probed = Math.max(1, Math.min(PROBE_ROWS, PROBE_BYTES / stride()));
      return (int) Math.min(array.header().rows(), probed);
    }

    /** The number in a buffer that begins with one of the column. */
    double number(ByteBuffer values, int at) {
      return field.kind() == 'f'
          ? NpzCursor.real(values, at, field.bytes())
          : NpzCursor.whole(values, at, field);
    }
  }

  /**
   * An array of a file.
   *
   * @param name without its extension
   * @param header its header
   * @param method 0 stored, 8 deflated
   * @param offset file offset of its bytes, including the header
   * @param bytes their number in the file
   */
  record Array(String name, NpyHeader header, int method, long offset, long bytes) {
    ArrayBytes open(RecordingFile file) {
      return method == 0
          ? ArrayBytes.stored(file, offset, bytes)
          : ArrayBytes.deflated(file, offset, bytes);
    }

    /** Maximum number of elements by the file's size. */
    long roomForRows() {
      return method == 0
          ? Math.max(0, bytes - header.dataOffset()) / header.itemBytes()
          : Long.MAX_VALUE;
    }
  }

  /** Finds the columns of a file: of the array that is wanted, if any, else the first ones. */
  static NpzLayout of(RecordingFile file, Optional<String> wanted) throws IOException {
    boolean alone = NpyHeader.parse(file.read(0, NpyHeader.MAX_BYTES)).isPresent();
    Optional<List<ZipDirectory.ZipMember>> listed =
        alone ? Optional.of(List.of()) : ZipDirectory.of(file);
    List<ZipDirectory.ZipMember> entries =
        listed.isPresent() ? listed.get() : ZipDirectory.withoutDirectory(file);
    List<Array> arrays = arrays(file, entries);
    List<String> topics = topics(file, arrays);
    if (wanted.isPresent() && !topics.contains(wanted.get())) {
      throw new RecordingProblem(file.path(), Topics.missing(wanted.get(), topics));
    }
    List<Array> read =
        arrays.stream().filter(array -> wanted.orElse(array.name()).equals(array.name())).toList();
    Map<EventColumn, ArrayColumn> columns = namedColumns(read);
    List<EventColumn> guessed = areEvents(columns) ? List.of() : table(file, read, columns);
    if (!areEvents(columns)) {
      throw new RecordingProblem(
          file.path(),
          "its arrays "
              + arrays.stream().map(Array::name).toList()
              + " are not events: expected are t, x, y and p, as arrays or as fields or columns of"
              + " one");
    }
    if (listed.isEmpty() && !columns.containsKey(EventColumn.POLARITY)) {
      throw new RecordingProblem(
          file.path(), file.size(), "the file ends before the polarities of its events");
    }
    Optional<String> obstacle =
        columns.containsKey(EventColumn.POLARITY)
            ? ColumnGuess.obstacle(Arrays.stream(start(file, columns.get(EventColumn.POLARITY))))
            : ColumnGuess.obstacle(names(entries, arrays), columns.keySet());
    if (obstacle.isPresent()) {
      throw new RecordingProblem(file.path(), obstacle.get());
    }
    long rows = Long.MAX_VALUE;
    long maxRows = 0;
    boolean inconsistent = false;
    for (ArrayColumn column : columns.values()) {
      long promised = column.array().header().rows();
      inconsistent |= promised > column.array().roomForRows();
      rows = Math.min(rows, promised);
      maxRows = Math.max(maxRows, promised);
    }
    String topic = columns.get(EventColumn.TIME).array().name();
    // only Haltere's files have this
    Optional<Long> rowsUp = single(file, arrays, ROWS_UP);
    return new NpzLayout(
        columns,
        topics.contains(topic) ? Topics.readFirst(topic, topics) : List.of(),
        guessed,
        rows,
        inconsistent || rows != maxRows,
        listed.isEmpty(),
        rowsUp.isPresent() ? 0 : timeScale(file, columns.get(EventColumn.TIME), listed.isEmpty()),
        sensor(file, arrays),
        rowsUp.map(up -> up == 1 ? Origin.BOTTOM : Origin.TOP));
  }

  /** Names of the arrays that hold events on their own. */
  private static List<String> topics(RecordingFile file, List<Array> arrays) throws IOException {
    List<String> topics = new ArrayList<>();
    for (Array array : arrays) {
      if (!array.name().isEmpty() && isTopic(file, array)) {
        topics.add(array.name());
      }
    }
    return topics;
  }

  private static boolean isTopic(RecordingFile file, Array array) throws IOException {
    Map<EventColumn, ArrayColumn> columns = namedColumns(List.of(array));
    try {
      return areEvents(columns) || !table(file, List.of(array), columns).isEmpty();
    } catch (RecordingProblem unreadable) {
      // reported if it is the one to read
      return false;
    }
  }

  /** Columns by name: the fields of one array, or else arrays side by side. */
  private static Map<EventColumn, ArrayColumn> namedColumns(List<Array> arrays) {
    for (Array array : arrays) {
      Map<EventColumn, ArrayColumn> fields = new EnumMap<>(EventColumn.class);
      addColumns(fields, array);
      if (areEvents(fields)) {
        return fields;
      }
    }
    Map<EventColumn, ArrayColumn> columns = new EnumMap<>(EventColumn.class);
    arrays.forEach(array -> addColumns(columns, array));
    return columns;
  }

  private static void addColumns(Map<EventColumn, ArrayColumn> columns, Array array) {
    for (NpyHeader.NpyField field : array.header().fields()) {
      String name = field.name().isEmpty() ? array.name() : field.name();
      EventColumn column = EventColumn.named(name);
      if (column != EventColumn.OTHER && field.isNumber() && array.header().isList()) {
        columns.putIfAbsent(column, new ArrayColumn(array, field));
      }
    }
  }

  private static boolean areEvents(Map<EventColumn, ArrayColumn> columns) {
    return EventColumn.areEvents(columns.keySet());
  }

  /** Adds the columns of a table of events, and returns their contents; none without one. */
  private static List<EventColumn> table(
      RecordingFile file, List<Array> arrays, Map<EventColumn, ArrayColumn> columns)
      throws IOException {
    for (Array array : arrays) {
      List<NpyHeader.NpyField> fields = array.header().fields();
      if (!array.header().isTable() || !fields.get(0).isNumber()) {
        continue;
      }
      List<double[]> numbers = new ArrayList<>();
      for (NpyHeader.NpyField field : fields) {
        ArrayColumn column = new ArrayColumn(array, field);
        double[] start = start(file, column);
        if (start.length < column.probedRows()) {
          throw new RecordingProblem(
              file.path(), file.size(), "the file ends before its columns are known");
        }
        numbers.add(start);
      }
      List<EventColumn> found = ColumnGuess.of(numbers, array.header().rows());
      if (!found.isEmpty()) {
        columns.clear();
        for (int i = 0; i < found.size(); i++) {
          columns.put(found.get(i), new ArrayColumn(array, fields.get(i)));
        }
        return found;
      }
    }
    return List.of();
  }

  /** The first numbers of a column. */
  private static double[] start(RecordingFile file, ArrayColumn column) throws IOException {
    int stride = column.stride();
    byte[] start = new byte[column.probedRows() * stride];
    ArrayBytes bytes = column.array().open(file);
    int length = bytes.read(column.start(), start, start.length);
    bytes.close();
    ByteBuffer values = order(ByteBuffer.wrap(start), column.field());
    int offset = column.offset();
    double[] numbers = new double[length / stride];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = column.number(values, i * stride + offset);
    }
    return numbers;
  }

  /** Names of all arrays, readable or not, and of their fields. */
  private static Stream<String> names(List<ZipDirectory.ZipMember> entries, List<Array> arrays) {
    return Stream.concat(
        entries.stream().map(NpzLayout::arrayName),
        arrays.stream()
            .flatMap(array -> array.header().fields().stream())
            .map(NpyHeader.NpyField::name));
  }

  private static String arrayName(ZipDirectory.ZipMember entry) {
    return entry.name().replaceFirst("^.*/", "").replaceFirst("\\.npy$", "");
  }

  private static List<Array> arrays(RecordingFile file, List<ZipDirectory.ZipMember> entries)
      throws IOException {
    Optional<NpyHeader> alone = NpyHeader.parse(file.read(0, NpyHeader.MAX_BYTES));
    if (alone.isPresent()) {
      return List.of(new Array("", alone.get(), 0, 0, file.size()));
    }
    List<Array> arrays = new ArrayList<>();
    for (ZipDirectory.ZipMember entry : entries) {
      if (entry.method() != 0 && entry.method() != 8) {
        continue;
      }
      Array unknown =
          new Array(
              arrayName(entry), null, entry.method(), entry.offset(), entry.compressedBytes());
      byte[] start = new byte[NpyHeader.MAX_BYTES];
      ArrayBytes bytes = unknown.open(file);
      int length = bytes.read(0, start, start.length);
      bytes.close();
      NpyHeader.parse(Arrays.copyOf(start, length))
          .ifPresent(
              header ->
                  arrays.add(
                      new Array(
                          unknown.name(),
                          header,
                          unknown.method(),
                          unknown.offset(),
                          unknown.bytes())));
    }
    return arrays;
  }

  /** Time unit: by the column's name, else by its numbers. */
  private static int timeScale(RecordingFile file, ArrayColumn time, boolean cutOff)
      throws IOException {
    String name = time.field().name().isEmpty() ? time.array().name() : time.field().name();
    if (EventColumn.timeScale(name).isPresent()) {
      return EventColumn.timeScale(name).getAsInt();
    }
    double[] start = start(file, time);
    double largest = 0;
    boolean fraction = false;
    for (double value : start) {
      if (RowCursor.rounded(value) != RowCursor.NO_NUMBER) {
        fraction |= value != Math.rint(value);
        largest = Math.max(largest, Math.abs(value));
      }
    }
    if (cutOff && !fraction && time.field().kind() == 'f' && start.length < time.probedRows()) {
      throw new RecordingProblem(
          file.path(), file.size(), "the file ends before the unit of its times is known");
    }
    return EventColumn.timeScale(fraction, largest);
  }

  static ByteBuffer order(ByteBuffer buffer, NpyHeader.NpyField field) {
    return buffer.order(field.bigEndian() ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN);
  }

  private static Optional<SensorGeometry> sensor(RecordingFile file, List<Array> arrays)
      throws IOException {
    long width = single(file, arrays, WIDTH).orElse(0L);
    long height = single(file, arrays, HEIGHT).orElse(0L);
    boolean possible = width >= 1 && width <= 32768 && height >= 1 && height <= 32768;
    return possible
        ? Optional.of(new SensorGeometry((int) width, (int) height, Origin.TOP))
        : Optional.empty();
  }

  /** The value of an array without dimensions. */
  private static Optional<Long> single(RecordingFile file, List<Array> arrays, String name)
      throws IOException {
    for (Array array : arrays) {
      NpyHeader.NpyField field = array.header().fields().get(0);
      if (array.name().equals(name)
          && array.header().shape().isEmpty()
          && field.isNumber()
          && field.kind() != 'f') {
        byte[] value = new byte[8];
        ArrayBytes bytes = array.open(file);
        int length = bytes.read(array.header().dataOffset(), value, field.bytes());
        bytes.close();
        if (length == field.bytes()) {
          return Optional.of(NpzCursor.whole(order(ByteBuffer.wrap(value), field), 0, field));
        }
      }
    }
    return Optional.empty();
  }
}
