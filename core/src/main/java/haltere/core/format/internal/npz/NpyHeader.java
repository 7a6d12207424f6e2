package haltere.core.format.internal.npz;

import haltere.core.format.internal.decoding.ColumnGuess;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The header of a NumPy array: type and number of its elements. The rows of a table of four columns
 * are its elements, with a field for each column.
 *
 * @param fields of an element; those of a table have no names, nor has the only one of a plain
 *     array
 * @param itemBytes size of an element
 * @param shape lengths of its dimensions; they may be wrong
 * @param dataOffset bytes of the header
 * @param isByColumns whether each column of a table is stored as a whole
 */
record NpyHeader(
    List<NpyField> fields, int itemBytes, List<Long> shape, int dataOffset, boolean isByColumns) {
  /** Maximum length of a header. */
  static final int MAX_BYTES = 64 * 1024;

  private static final byte[] MAGIC = {(byte) 0x93, 'N', 'U', 'M', 'P', 'Y'};
  private static final Pattern DESCRIPTION =
      Pattern.compile("'descr'\\s*:\\s*('[^']*'|\\[[^\\]]*\\])");
  private static final Pattern FIELD =
      Pattern.compile(
          "\\(\\s*'([^']*)'\\s*,\\s*'([^']*)'\\s*,?\\s*(\\(\\s*\\d*\\s*,?\\s*\\))?\\s*\\)");
  private static final Pattern TYPE = Pattern.compile("([<>|=]?)([a-zA-Z?])(\\d{0,6})");
  private static final Pattern BY_COLUMNS = Pattern.compile("'fortran_order'\\s*:\\s*True");
  private static final Pattern SHAPE = Pattern.compile("'shape'\\s*:\\s*\\(([\\d,\\sL]*)\\)");

  /**
   * A number in an element.
   *
   * @param name empty unless the array is structured
   * @param kind {@code i} signed integer, {@code u} unsigned integer, {@code f} floating point,
   *     {@code b} boolean, others are not read
   * @param bytes its size
   * @param offset of it in the element
   * @param bigEndian whether its first byte is the highest
   */
  record NpyField(String name, char kind, int bytes, int offset, boolean bigEndian) {
    /** Whether it is a supported number. */
    boolean isNumber() {
      return switch (kind) {
        case 'i', 'u' -> bytes == 1 || bytes == 2 || bytes == 4 || bytes == 8;
        case 'f' -> bytes == 4 || bytes == 8;
        case 'b', '?' -> bytes == 1;
        default -> false;
      };
    }
  }

  /** Reads a header from the start of an array; empty if it is missing or incomplete. */
  static Optional<NpyHeader> parse(byte[] bytes) {
    if (bytes.length < 10) {
      return Optional.empty();
    }
    for (int i = 0; i < MAGIC.length; i++) {
      if (bytes[i] != MAGIC[i]) {
        return Optional.empty();
      }
    }
    long length = bytes[8] & 0xff | (bytes[9] & 0xff) << 8;
    int start = 10;
    if (bytes[6] >= 2) {
      if (bytes.length < 12) {
        return Optional.empty();
      }
      length |= (bytes[10] & 0xffL) << 16 | (bytes[11] & 0xffL) << 24;
      start = 12;
    }
    if (length > bytes.length - start) {
      return Optional.empty();
    }
    String text = new String(bytes, start, (int) length, StandardCharsets.ISO_8859_1);
    Matcher description = DESCRIPTION.matcher(text);
    Matcher shape = SHAPE.matcher(text);
    if (!description.find() || !shape.find()) {
      return Optional.empty();
    }
    List<NpyField> fields = fields(description.group(1));
    Optional<List<Long>> lengths = lengths(shape.group(1)).map(NpyHeader::asList);
    int itemBytes = fields.stream().mapToInt(NpyField::bytes).sum();
    if (fields.isEmpty() || lengths.isEmpty() || itemBytes < 1) {
      return Optional.empty();
    }
    int dataOffset = start + (int) length;
    NpyHeader header = new NpyHeader(fields, itemBytes, lengths.get(), dataOffset, false);
    return Optional.of(
        fields.get(0).name().isEmpty() && lengths.get().size() == 2
            ? header.asTable(BY_COLUMNS.matcher(text).find())
            : header);
  }

  /** Lengths of an array, where a single row or column is a list; four numbers are a table. */
  private static List<Long> asList(List<Long> lengths) {
    boolean isColumn = lengths.size() == 2 && lengths.get(1) == 1;
    boolean isRow =
        lengths.size() == 2 && lengths.get(0) == 1 && lengths.get(1) != ColumnGuess.COLUMNS;
    return isColumn || isRow ? List.of(lengths.get(isColumn ? 0 : 1)) : lengths;
  }

  /** Four columns as fields; the array itself if it has not as many. */
  private NpyHeader asTable(boolean isTransposed) {
    boolean isUpright = shape.get(1) == ColumnGuess.COLUMNS;
    if (!isUpright && shape.get(0) != ColumnGuess.COLUMNS) {
      return this;
    }
    NpyField any = fields.get(0);
    List<NpyField> columns = new ArrayList<>();
    for (int i = 0; i < ColumnGuess.COLUMNS; i++) {
      columns.add(new NpyField("", any.kind(), any.bytes(), i * any.bytes(), any.bigEndian()));
    }
    return new NpyHeader(
        columns,
        ColumnGuess.COLUMNS * itemBytes,
        List.of(shape.get(isUpright ? 0 : 1)),
        dataOffset,
        isUpright == isTransposed);
  }

  /** Whether it is a table of columns without names. */
  boolean isTable() {
    return fields.size() == ColumnGuess.COLUMNS && fields.get(0).name().isEmpty();
  }

  private static List<NpyField> fields(String description) {
    List<NpyField> fields = new ArrayList<>();
    if (description.startsWith("'")) {
      field("", description.substring(1, description.length() - 1), 0).ifPresent(fields::add);
      return fields;
    }
    Matcher field = FIELD.matcher(description);
    int offset = 0;
    while (field.find()) {
      Optional<NpyField> found = field(field.group(1), field.group(2), offset);
      if (found.isEmpty() || field.group(3) != null) {
        return List.of();
      }
      fields.add(found.get());
      offset += found.get().bytes();
    }
    return fields;
  }

  private static Optional<NpyField> field(String name, String type, int offset) {
    Matcher parts = TYPE.matcher(type);
    if (!parts.matches()) {
      return Optional.empty();
    }
    char kind = parts.group(2).charAt(0);
    int bytes = parts.group(3).isEmpty() ? 1 : Integer.parseInt(parts.group(3));
    return Optional.of(
        new NpyField(
            name, kind, kind == 'U' ? 4 * bytes : bytes, offset, parts.group(1).equals(">")));
  }

  private static Optional<List<Long>> lengths(String text) {
    List<Long> lengths = new ArrayList<>();
    for (String length : text.replace("L", "").split(",")) {
      if (!length.isBlank()) {
        try {
          lengths.add(Long.parseLong(length.strip()));
        } catch (NumberFormatException ignored) {
          return Optional.empty();
        }
      }
    }
    return Optional.of(lengths);
  }

  /** Elements in the first dimension; 1 for an array without dimensions. */
  long rows() {
    return shape.isEmpty() ? 1 : shape.get(0);
  }

  /** Whether it is a list of elements, not a table or a single one. */
  boolean isList() {
    return shape.size() == 1;
  }

  /** Bytes of a header for a list of one type, a multiple of 64 as NumPy writes them. */
  static byte[] of(String type, String shape) {
    String text = "{'descr': '" + type + "', 'fortran_order': False, 'shape': (" + shape + "), }";
    int length = (10 + text.length() + 1 + 63) / 64 * 64 - 10;
    byte[] bytes = new byte[10 + length];
    System.arraycopy(MAGIC, 0, bytes, 0, MAGIC.length);
    bytes[6] = 1;
    bytes[8] = (byte) length;
    bytes[9] = (byte) (length >> 8);
    java.util.Arrays.fill(bytes, 10, bytes.length, (byte) ' ');
    byte[] ascii = text.getBytes(StandardCharsets.US_ASCII);
    System.arraycopy(ascii, 0, bytes, 10, ascii.length);
    bytes[bytes.length - 1] = '\n';
    return bytes;
  }
}
