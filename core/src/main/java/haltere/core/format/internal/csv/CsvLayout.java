package haltere.core.format.internal.csv;

import haltere.core.format.internal.decoding.ColumnGuess;
import haltere.core.format.internal.decoding.EventColumn;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;

/**
 * Columns of a text table: by a row of names, else by the numbers.
 *
 * @param roles of the columns, in order
 * @param timeScale power of ten of the times' unit in microseconds: 0 for microseconds, 6 for
 *     seconds, -3 for nanoseconds
 * @param dataOffset offset of the first row of events
 * @param named whether there are names
 * @param marked whether commas or semicolons separate the columns, not only spaces
 * @param decimalCommas whether commas are decimal points, since semicolons separate the columns
 * @param quoted whether fields are in quotes
 * @param width columns of the sensor from a first row of two numbers, else 0
 * @param height rows of the sensor likewise
 * @param obstacle why its events cannot be read, if so
 */
record CsvLayout(
    List<EventColumn> roles,
    int timeScale,
    int dataOffset,
    boolean named,
    boolean marked,
    boolean decimalCommas,
    boolean quoted,
    int width,
    int height,
    Optional<String> obstacle) {
  private static final int PROBE_ROWS = 2000;
  private static final int MAX_COLUMNS = 32;
  private static final String BLANKS = " \t\n\u000b\f\r";

  CsvLayout {
    roles = List.copyOf(roles);
  }

  /**
   * Whether it may be a table of something else than events, such as the positions of objects: it
   * names further columns, but no polarity.
   */
  boolean isDoubtful() {
    return named && roles.contains(EventColumn.OTHER) && !roles.contains(EventColumn.POLARITY);
  }

  /** Examines the start of a text; empty if it is not a table of events. */
  static Optional<CsvLayout> of(byte[] head) {
    String text = new String(head, StandardCharsets.ISO_8859_1);
    if (text.startsWith("\u00ef\u00bb\u00bf")) {
      text = text.substring(3);
      return of(text, 3);
    }
    return of(text, 0);
  }

  private static Optional<CsvLayout> of(String text, int skipped) {
    if (text.chars().limit(4096).anyMatch(c -> c < ' ' && c != '\n' && c != '\r' && c != '\t')) {
      return Optional.empty();
    }
    Start start = new Start();
    int offset = 0;
    while (offset < text.length() && start.rows.size() < PROBE_ROWS) {
      int end = text.indexOf('\n', offset);
      boolean whole = end >= 0;
      String line = text.substring(offset, whole ? end : text.length()).strip();
      boolean joined = start.rows.isEmpty() && line.indexOf('\r') >= 0;
      if (joined || !line.isEmpty() && !start.take(line, offset + skipped, whole)) {
        return Optional.empty();
      }
      offset = whole ? end + 1 : text.length();
    }
    if (start.dataOffset < 0) {
      start.dataOffset = offset + skipped;
    }
    boolean named = start.names != null && start.adaptNames();
    if (!named && start.names != null && !start.inComment) {
      return Optional.empty();
    }
    return named ? Optional.of(byNames(start)) : bySight(start);
  }

  /** The contents of the first lines of a text. */
  private static final class Start {
    final List<String[]> rows = new ArrayList<>();
    String[] names;
    boolean inComment;
    int width;
    int height;
    int dataOffset = -1;
    boolean marked;
    boolean decimalCommas;
    boolean quoted;

    /**
     * Adds a line.
     *
     * @param at byte offset in the file
     * @param whole false for an unterminated last line
     * @return false if this is not a text of events
     */
    boolean take(String line, int at, boolean whole) {
      boolean comment = line.startsWith("#") || line.startsWith("%");
      String text = comment ? line.substring(1) : line;
      String[] fields = fields(text);
      if (comment || !isRow(fields)) {
        return !rows.isEmpty() || takeNames(text, comment) || comment;
      }
      if (fields.length == 2 && rows.isEmpty() && width == 0) {
        width = size(fields[0]);
        height = size(fields[1]);
        return width != 0 && height != 0;
      }
      if (rows.isEmpty()) {
        dataOffset = at;
        decimalCommas = line.indexOf(';') >= 0;
        marked = decimalCommas || line.indexOf(',') >= 0;
      }
      quoted |= line.indexOf('"') >= 0;
      if (whole || rows.isEmpty()) {
        rows.add(fields);
      }
      return true;
    }

    /** Whether these are numbers: with names, the time is one, since polarities may be words. */
    private boolean isRow(String... fields) {
      int column = names == null ? 0 : timeColumn(names);
      return isNumber(fields[0]) || column < fields.length && isNumber(fields[column]);
    }

    /** A comment may name the columns, or a line of its own, once. */
    private boolean takeNames(String text, boolean comment) {
      String line = withUnicode(text);
      boolean tabbed = roles(fields(line, "\t")).isPresent();
      String[] fields = tabbed ? fields(line, "\t") : fields(line);
      boolean taken = (names == null || inComment) && roles(fields).isPresent();
      if (taken) {
        names = fields;
        inComment = comment;
      }
      return taken;
    }

    /**
     * Adapts the names to rows that begin with their own number, which has no name.
     *
     * @return false if there are more names than columns
     */
    boolean adaptNames() {
      boolean isNumbered = !rows.isEmpty();
      boolean isComplete = rows.isEmpty();
      for (int i = 0; i < rows.size(); i++) {
        String[] row = rows.get(i);
        isComplete |= row.length >= names.length;
        isNumbered &=
            row.length == names.length + 1
                && !row[row.length - 1].isEmpty()
                && isNumber(row[0])
                && Double.parseDouble(row[0]) == Double.parseDouble(rows.get(0)[0]) + i;
      }
      if (isNumbered) {
        names = Stream.concat(Stream.of(""), Stream.of(names)).toArray(String[]::new);
      }
      return isComplete;
    }

    /** Why the polarities of the rows cannot be read. */
    Optional<String> obstacle(List<EventColumn> roles) {
      int column = roles.indexOf(EventColumn.POLARITY);
      List<String> words =
          rows.stream()
              .filter(row -> 0 <= column && column < row.length)
              .map(r -> r[column])
              .toList();
      boolean known =
          words.stream().anyMatch(word -> isNumber(word) || CsvRow.polarity(word).isPresent());
      return known || words.isEmpty()
          ? ColumnGuess.obstacle(
              words.stream().filter(CsvLayout::isNumber).mapToDouble(Double::parseDouble))
          : Optional.of(
              "its polarities, such as "
                  + words.get(0)
                  + ", are no known words; write them as 1 (ON) and 0 (OFF)");
    }
  }

  private static CsvLayout byNames(Start start) {
    return new CsvLayout(
        roles(start.names).orElseThrow(),
        timeScale(start.names, start.rows),
        start.dataOffset,
        true,
        start.marked,
        start.decimalCommas,
        start.quoted,
        start.width,
        start.height,
        start.obstacle(roles(start.names).orElseThrow()));
  }

  private static String[] fields(String line) {
    return line.indexOf(';') >= 0
        ? fields(line.replace(',', '.'), ";")
        : fields(line, line.indexOf(',') >= 0 ? "," : "\\s+");
  }

  /** Parts of a line between separators; names may have spaces where tabs separate them. */
  private static String[] fields(String line, String separator) {
    String[] fields = line.strip().split(separator, MAX_COLUMNS + 1);
    for (int i = 0; i < fields.length; i++) {
      fields[i] = withoutBlanks(fields[i]);
    }
    return fields;
  }

  private static String withoutBlanks(String field) {
    int from = 0;
    int to = field.length();
    while (from < to && BLANKS.indexOf(field.charAt(from)) >= 0) {
      from++;
    }
    while (to > from && BLANKS.indexOf(field.charAt(to - 1)) >= 0) {
      to--;
    }
    boolean quoted = to > from + 1 && field.charAt(from) == '"' && field.charAt(to - 1) == '"';
    return quoted ? field.substring(from + 1, to - 1) : field.substring(from, to);
  }

  /** A line of UTF-8, or of Latin-1 if it is not that. */
  private static String withUnicode(String line) {
    String unicode = new String(line.getBytes(StandardCharsets.ISO_8859_1), StandardCharsets.UTF_8);
    return unicode.indexOf('\ufffd') < 0 ? unicode : line;
  }

  private static int size(String field) {
    try {
      int size = Integer.parseInt(field);
      return size >= 1 && size <= 32768 ? size : 0;
    } catch (NumberFormatException ignored) {
      return 0;
    }
  }

  private static boolean isNumber(String field) {
    try {
      Double.parseDouble(field);
      return true;
    } catch (NumberFormatException ignored) {
      return false;
    }
  }

  /** Columns by name; empty unless time, column and row are among them. */
  private static Optional<List<EventColumn>> roles(String[] names) {
    if (names.length > MAX_COLUMNS) {
      return Optional.empty();
    }
    List<EventColumn> roles = new ArrayList<>();
    for (String name : names) {
      EventColumn role = EventColumn.named(name);
      roles.add(role != EventColumn.OTHER && roles.contains(role) ? EventColumn.OTHER : role);
    }
    return EventColumn.areEvents(roles) ? Optional.of(roles) : Optional.empty();
  }

  /** The first column of times among names that have one. */
  private static int timeColumn(String... names) {
    int column = 0;
    while (EventColumn.named(names[column]) != EventColumn.TIME) {
      column++;
    }
    return column;
  }

  private static int timeScale(String[] names, List<String[]> rows) {
    int column = timeColumn(names);
    OptionalInt stated = EventColumn.timeScale(names[column]);
    return stated.isPresent() ? stated.getAsInt() : timeScale(rows, column);
  }

  private static int timeScale(List<String[]> rows, int column) {
    boolean fraction = false;
    double largest = 0;
    for (String[] row : rows) {
      if (column < row.length && isNumber(row[column])) {
        double value = Double.parseDouble(row[column]);
        fraction |= value != Math.rint(value);
        largest = Math.max(largest, Math.abs(value));
      }
    }
    return EventColumn.timeScale(fraction, largest);
  }

  /** Columns by their numbers. */
  private static Optional<CsvLayout> bySight(Start start) {
    ColumnGuess guess = new ColumnGuess();
    for (String[] row : start.rows) {
      boolean ends = row.length == ColumnGuess.COLUMNS + 1 && row[ColumnGuess.COLUMNS].isEmpty();
      String[] numbers = ends ? Arrays.copyOf(row, ColumnGuess.COLUMNS) : row;
      if (numbers.length != ColumnGuess.COLUMNS
          || !Stream.of(numbers).allMatch(CsvLayout::isNumber)) {
        return Optional.empty();
      }
      guess.add(Stream.of(numbers).mapToDouble(Double::parseDouble).toArray());
    }
    return guess
        .columns()
        .map(
            roles ->
                new CsvLayout(
                    roles,
                    timeScale(start.rows, roles.indexOf(EventColumn.TIME)),
                    start.dataOffset,
                    false,
                    start.marked,
                    start.decimalCommas,
                    start.quoted,
                    start.width,
                    start.height,
                    Optional.empty()));
  }
}
