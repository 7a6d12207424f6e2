package haltere.core.format.internal.csv;

import haltere.core.event.EventAddress;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.internal.decoding.EventColumn;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * A row of text, read exactly with all forms of numbers: signs, decimals, exponents, words for
 * polarities, additional columns.
 *
 * <p>Thread rule: one thread.
 */
final class CsvRow {
  private static final int MAX_WORD = 16;
  private static final int MAX_EXPONENT = 40;
  private static final int MAX_SCALE = 4096;
  private static final int MAX_CHARACTERS = 2 * MAX_SCALE;
  private static final Pattern NUMBER =
      Pattern.compile("[+-]?(\\d++(\\.\\d*+)?|\\.\\d++)([eE][+-]?\\d++)?");

  private static final Map<String, Integer> POLARITIES =
      Map.ofEntries(
          Map.entry("true", 1),
          Map.entry("on", 1),
          Map.entry("cd_on", 1),
          Map.entry("pos", 1),
          Map.entry("positive", 1),
          Map.entry("increase", 1),
          Map.entry("+", 1),
          Map.entry("false", 0),
          Map.entry("off", 0),
          Map.entry("cd_off", 0),
          Map.entry("neg", 0),
          Map.entry("negative", 0),
          Map.entry("decrease", 0),
          Map.entry("-", 0));

  private final EventColumn[] roles;
  private final int timeScale;
  private final boolean polarity;
  private final boolean marked;
  private final int width;
  private final int top;
  private final boolean fromTop;
  private byte[] piece;

  /** Whether the number read last is invalid. */
  private boolean invalid;

  /** Position of the parser in the piece. */
  private int cursor;

  private int address;
  private long timeUs;
  private boolean remark;

  CsvRow(CsvLayout layout, SensorGeometry geometry) {
    List<EventColumn> columns = layout.roles();
    roles = columns.toArray(EventColumn[]::new);
    timeScale = layout.timeScale();
    polarity = columns.contains(EventColumn.POLARITY);
    marked = layout.marked();
    width = geometry.width();
    top = geometry.height() - 1;
    fromTop = geometry.origin() == Origin.TOP;
  }

  /** The polarity of a word, above 0 for ON. */
  static Optional<Integer> polarity(String word) {
    return Optional.ofNullable(POLARITIES.get(word.toLowerCase(Locale.ROOT)));
  }

  /** Reads the row at an index, which ends in a line feed; false if it is not an event. */
  boolean parse(byte[] bytes, int row) {
    piece = bytes;
    cursor = row;
    if (parseColumns()) {
      return true;
    }
    cursor = row;
    while (piece[cursor] == ' ' || piece[cursor] == '\t' || piece[cursor] == '\r') {
      cursor++;
    }
    remark = piece[cursor] == '\n' || piece[cursor] == '#' || piece[cursor] == '%';
    while (piece[cursor] != '\n') {
      cursor++;
    }
    cursor++;
    return false;
  }

  /** Whether a row without an event is empty or a comment. */
  boolean isRemark() {
    return remark;
  }

  /** Index after the row. */
  int end() {
    return cursor;
  }

  /** Time of the row's event. */
  long timeUs() {
    return timeUs;
  }

  /** Address of the row's event; negative if it is outside the sensor. */
  int address() {
    return address;
  }

  /** Reads the columns of a row and advances past its end; false if they are invalid. */
  private boolean parseColumns() {
    long x = 0;
    long y = 0;
    int on = polarity ? 0 : EventAddress.ON_BIT;
    int columns = roles.length;
    for (int i = 0; i < columns; i++) {
      if (i > 0 && !separator()) {
        return false;
      }
      EventColumn role = roles[i];
      int scale = role == EventColumn.TIME ? timeScale : 0;
      long value = number(scale);
      if (value == Long.MIN_VALUE && role != EventColumn.OTHER && invalid) {
        return false;
      }
      switch (role) {
        case TIME -> timeUs = value;
        case X -> x = value;
        case Y -> y = value;
        case POLARITY -> on = value > 0 ? EventAddress.ON_BIT : 0;
        default -> {
          // ignored column
        }
      }
    }
    if (!separatorOrEnd()) {
      return false;
    }
    while (piece[cursor] != '\n') {
      cursor++;
    }
    cursor++;
    long up = fromTop ? top - y : y;
    address =
        x < 0 || x >= width || y < 0 || y > top
            ? -1
            : (int) up << EventAddress.Y_SHIFT | (int) x << EventAddress.X_SHIFT | on;
    return true;
  }

  /** Whether the columns end here, or further ones are ignored. */
  private boolean separatorOrEnd() {
    boolean separated = separator();
    while (piece[cursor] == '\r') {
      cursor++;
    }
    return separated || piece[cursor] == '\n';
  }

  private boolean separator() {
    boolean spaces = false;
    while (piece[cursor] == ' ' || piece[cursor] == '\t') {
      cursor++;
      spaces = true;
    }
    if (piece[cursor] == ',' || piece[cursor] == ';') {
      cursor++;
      return true;
    }
    return spaces && (!marked || piece[cursor] <= ' ');
  }

  /**
   * The number at the cursor times a power of ten, rounded to an integer; {@link Long#MIN_VALUE}
   * and {@link #invalid} if there is none.
   */
  private long number(int scale) {
    invalid = false;
    while (piece[cursor] == ' ' || piece[cursor] == '\t') {
      cursor++;
    }
    int start = cursor;
    boolean negative = piece[start] == '-';
    int at = negative || piece[start] == '+' ? start + 1 : start;
    int first = at;
    long value = 0;
    int digit;
    while ((digit = piece[at] - '0') >= 0 && digit <= 9) {
      value = value * 10 + digit;
      at++;
    }
    int end = piece[at];
    if (scale == 0
        && at > first
        && at - first <= Digits.MAX_DIGITS
        && (end == ',' || end <= ' ' || end == ';')) {
      cursor = at;
      return negative ? -value : value;
    }
    int fraction = 0;
    int point = at;
    if (end == '.') {
      at++;
      while ((digit = piece[at] - '0') >= 0 && digit <= 9) {
        value = value * 10 + digit;
        at++;
      }
      fraction = at - point - 1;
      end = piece[at];
    }
    int digits = point - first + fraction;
    int power = scale - fraction;
    if (digits > 0
        && digits <= Digits.MAX_DIGITS
        && (end == ',' || end <= ' ' || end == ';')
        && power <= 0
        && power >= -Digits.MAX_DIGITS) {
      cursor = at;
      long unit = Digits.power(-power);
      long whole = (value + unit / 2) / unit;
      return negative ? -whole : whole;
    }
    if (digits > 0
        && power > 0
        && power < Digits.MAX_DIGITS
        && digits + power <= Digits.MAX_DIGITS
        && (end == ',' || end <= ' ' || end == ';')) {
      cursor = at;
      return negative ? -value * Digits.power(power) : value * Digits.power(power);
    }
    return rareNumber(start, scale);
  }

  /** Reads exponents, words for polarities, and numbers with more digits than a long. */
  private long rareNumber(int start, int scale) {
    int end = start;
    while (piece[end] > ' ' && piece[end] != ',' && piece[end] != ';') {
      end++;
    }
    cursor = end;
    String text = new String(piece, start, end - start, StandardCharsets.ISO_8859_1);
    Optional<Integer> word = text.length() < MAX_WORD ? polarity(text) : Optional.empty();
    if (word.isPresent()) {
      return word.get();
    }
    if (text.length() <= MAX_CHARACTERS && NUMBER.matcher(text).matches()) {
      try {
        BigDecimal exact = new BigDecimal(text);
        if (Math.abs((long) exact.precision() - exact.scale()) <= MAX_EXPONENT
            && Math.abs((long) exact.scale()) <= MAX_SCALE) {
          return exact.scaleByPowerOfTen(scale).setScale(0, RoundingMode.HALF_UP).longValueExact();
        }
      } catch (ArithmeticException | NumberFormatException ignored) {
        // an exponent beyond an int, or a value beyond a long: reported below
      }
    }
    invalid = true;
    return Long.MIN_VALUE;
  }
}
