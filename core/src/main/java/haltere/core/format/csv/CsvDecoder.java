package haltere.core.format.csv;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.EventColumn;
import haltere.core.format.StreamDecoder;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.stream.StreamNotification;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;

/**
 * Turns rows of numbers into packets. Numbers are taken exactly as they are written; a time between
 * two microseconds goes to the nearer one. Rows are taken to count from the top.
 *
 * <p>Thread rule: one thread.
 */
final class CsvDecoder implements StreamDecoder {
  /** Longer rows are none. */
  private static final int MAX_ROW = 4096;

  private static final int PIECE = 64 * 1024;

  /** Bytes that may be looked at behind the piece. */
  private static final int PADDING = 16;

  private static final VarHandle EIGHT_BYTES =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);
  private static final int MAX_DIGITS = 18;
  private static final int MAX_EXPONENT = 40;
  private static final long MAX_SECONDS = 1_000_000_000_000L;
  private static final long ZEROES = 0x3030303030303030L;
  private static final long HIGH_BITS = 0x8080808080808080L;
  private static final long[] POWERS = new long[MAX_DIGITS + 1];

  static {
    POWERS[0] = 1;
    for (int i = 1; i <= MAX_DIGITS; i++) {
      POWERS[i] = POWERS[i - 1] * 10;
    }
  }

  private final EventColumn[] roles;
  private final int timeScale;
  private final boolean polarity;
  private final int timeColumn;
  private final int xColumn;
  private final int yColumn;
  private final int onColumn;

  /** Whether plain rows give the time as it is, or in seconds. */
  private final boolean unscaled;

  private final boolean marked;
  private final int width;
  private final int top;
  private final ViolationCounts violations;

  private final byte[] piece = new byte[PIECE + PADDING];
  private long lastUs = StreamNotification.NO_TIME_US;
  private boolean restarted;
  private long restartUs;
  private boolean inLongRow;

  /** Whether the number that was read last is none. */
  private boolean invalid;

  /** Where in the piece the parser is. */
  private int cursor;

  private int address;
  private long timeUs;

  CsvDecoder(CsvLayout layout, SensorGeometry geometry, ViolationCounts violations) {
    List<EventColumn> columns = layout.roles();
    roles = columns.toArray(EventColumn[]::new);
    polarity = columns.contains(EventColumn.POLARITY);
    timeScale = layout.timeScale();
    unscaled = timeScale == 0 || timeScale == 6;
    timeColumn = columns.indexOf(EventColumn.TIME);
    xColumn = columns.indexOf(EventColumn.X);
    yColumn = columns.indexOf(EventColumn.Y);
    onColumn = columns.indexOf(EventColumn.POLARITY);
    marked = layout.marked();
    width = geometry.width();
    top = geometry.height() - 1;
    this.violations = violations;
  }

  @Override
  public boolean decode(ByteBuffer in, long offset, EventPacket out, int maxEvents) {
    out.ensureCapacity(maxEvents);
    int start = in.position();
    int position = start;
    while (position < in.limit() && out.size() < maxEvents && !restarted) {
      int length = Math.min(PIECE, in.limit() - position);
      in.get(position, piece, 0, length);
      int used = decodePiece(length, offset + (position - start), out, maxEvents);
      if (used == 0 && !restarted) {
        used = length >= MAX_ROW ? skipLongRow(length, offset + (position - start)) : 0;
        if (used == 0) {
          break;
        }
      }
      position += used;
    }
    in.position(position);
    return restarted;
  }

  /** A row without an end in sight is passed over up to its end. */
  private int skipLongRow(int length, long offset) {
    if (!inLongRow) {
      inLongRow = true;
      violations.add(Violation.UNKNOWN_WORD, offset);
    }
    return length;
  }

  /** Decodes whole rows; returns the bytes of them. */
  private int decodePiece(int length, long offset, EventPacket out, int maxEvents) {
    int last = length - 1;
    while (last >= 0 && piece[last] != '\n') {
      last--;
    }
    int row = 0;
    while (row <= last && out.size() < maxEvents) {
      if (inLongRow) {
        while (piece[row] != '\n') {
          row++;
        }
        row++;
        inLongRow = false;
        continue;
      }
      row = decodePlainRows(row, last, out, maxEvents);
      if (row > last || out.size() == maxEvents) {
        break;
      }
      if (!decodeRow(row, offset + row, out)) {
        return row;
      }
      row = cursor;
    }
    return row;
  }

  /**
   * Decodes rows that are nothing but digits with one mark between them, as nearly all are; returns
   * where there is another. Eight digits are read at once, without asking how many there are.
   */
  private int decodePlainRows(int from, int last, EventPacket out, int maxEvents) {
    long[] times = out.timesUs();
    int[] addresses = out.addresses();
    byte[] bytes = piece;
    int columns = roles.length;
    int size = out.size();
    long previousUs = lastUs;
    int right = width - 1;
    int topRow = top;
    int timeColumn = this.timeColumn;
    int xColumn = this.xColumn;
    int yColumn = this.yColumn;
    int onColumn = this.onColumn;
    boolean seconds = timeScale == 6;
    int row = from;
    rows:
    while (row <= last && size < maxEvents) {
      int at = row;
      long time = 0;
      long x = 0;
      long y = 0;
      long on = 1;
      for (int i = 0; i < columns; i++) {
        long digits = (long) EIGHT_BYTES.get(bytes, at) ^ ZEROES;
        int count = count(digits);
        if (count == 0) {
          break rows;
        }
        long value = value(digits, count);
        at += count;
        if (count == 8) {
          digits = (long) EIGHT_BYTES.get(bytes, at) ^ ZEROES;
          count = count(digits);
          if (count == 8) {
            break rows;
          }
          if (count > 0) {
            value = value * POWERS[count] + value(digits, count);
            at += count;
          }
        }
        if (i == timeColumn && seconds) {
          if (bytes[at] != '.') {
            break rows;
          }
          digits = (long) EIGHT_BYTES.get(bytes, at + 1) ^ ZEROES;
          count = count(digits);
          if (count == 0 || count > 6 || value > MAX_SECONDS) {
            break rows;
          }
          value = value * 1_000_000 + value(digits, count) * POWERS[6 - count];
          at += 1 + count;
        }
        if (i == timeColumn) {
          time = value;
        } else if (i == xColumn) {
          x = value;
        } else if (i == yColumn) {
          y = value;
        } else if (i == onColumn) {
          on = value;
        }
        byte mark = bytes[at++];
        if (i < columns - 1) {
          if (marked ? mark != ',' && mark != ';' : mark != ' ' && mark != '\t') {
            break rows;
          }
        } else if (mark != '\n' && (mark != '\r' || bytes[at++] != '\n')) {
          break rows;
        }
      }
      if ((time - previousUs | right - x | topRow - y) < 0 || !unscaled) {
        break;
      }
      previousUs = time;
      times[size] = time;
      addresses[size++] =
          (int) (topRow - y) << EventAddress.Y_SHIFT
              | (int) x << EventAddress.X_SHIFT
              | (on > 0 ? EventAddress.ON_BIT : 0);
      row = at;
    }
    out.setSize(size);
    lastUs = previousUs;
    return row;
  }

  /** How many of eight bytes, less the character 0, are digits from the first on. */
  private static int count(long digits) {
    return Long.numberOfTrailingZeros((digits + 0x7676767676767676L | digits) & HIGH_BITS) >>> 3;
  }

  /** The number that the first of eight digits make, at least one. */
  private static long value(long digits, int count) {
    long eight = digits << (8 - count << 3);
    long pairs = eight * 10 + (eight >>> 8);
    return (pairs & 0x000000ff000000ffL) * (100 + (1_000_000L << 32))
            + (pairs >>> 16 & 0x000000ff000000ffL) * (1 + (10_000L << 32))
        >>> 32;
  }

  /** Decodes the row that starts somewhere and ends in a line feed; false if time goes back. */
  private boolean decodeRow(int row, long offset, EventPacket out) {
    cursor = row;
    boolean good = parseRow();
    if (!good) {
      int first = row;
      while (piece[first] == ' ' || piece[first] == '\t' || piece[first] == '\r') {
        first++;
      }
      cursor = first;
      while (piece[cursor] != '\n') {
        cursor++;
      }
      if (piece[first] != '\n' && piece[first] != '#' && piece[first] != '%') {
        violations.add(Violation.UNKNOWN_WORD, offset);
      }
      cursor++;
      return true;
    }
    if (address < 0) {
      violations.add(Violation.OUTSIDE_SENSOR, offset);
      return true;
    }
    if (timeUs < lastUs) {
      restarted = true;
      restartUs = timeUs;
      violations.add(Violation.CLOCK_WENT_BACK, offset);
      return false;
    }
    lastUs = timeUs;
    out.append(timeUs, address);
    return true;
  }

  /** Reads the columns of a row and goes behind its end; false if they are not what they should. */
  private boolean parseRow() {
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
          // Not of interest.
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
    long up = top - y;
    address =
        x < 0 || x >= width || y < 0 || up < 0
            ? -1
            : (int) up << EventAddress.Y_SHIFT | (int) x << EventAddress.X_SHIFT | on;
    return true;
  }

  /** Whether the columns end here, or there are more that nobody asked for. */
  private boolean separatorOrEnd() {
    boolean separated = separator();
    byte at = piece[cursor];
    return separated || at == '\n' || at == '\r';
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
   * The number at the cursor times a power of ten, rounded to a whole one; {@link Long#MIN_VALUE}
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
        && at - first <= MAX_DIGITS
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
        && digits <= MAX_DIGITS
        && (end == ',' || end <= ' ' || end == ';')
        && power <= 0
        && power >= -MAX_DIGITS) {
      cursor = at;
      long unit = POWERS[-power];
      long whole = (value + unit / 2) / unit;
      return negative ? -whole : whole;
    }
    if (digits > 0
        && power > 0
        && power < MAX_DIGITS
        && digits + power <= MAX_DIGITS
        && (end == ',' || end <= ' ' || end == ';')) {
      cursor = at;
      return negative ? -value * POWERS[power] : value * POWERS[power];
    }
    return rareNumber(start, scale);
  }

  /** Exponents, words for polarities, numbers with more digits than a long has. */
  private long rareNumber(int start, int scale) {
    int end = start;
    while (piece[end] > ' ' && piece[end] != ',' && piece[end] != ';') {
      end++;
    }
    cursor = end;
    String text = new String(piece, start, end - start, StandardCharsets.ISO_8859_1);
    if (text.equalsIgnoreCase("true") || text.equalsIgnoreCase("on")) {
      return 1;
    }
    if (text.equalsIgnoreCase("false") || text.equalsIgnoreCase("off")) {
      return 0;
    }
    try {
      BigDecimal exact = new BigDecimal(text);
      if (Math.abs((long) exact.precision() - exact.scale()) <= MAX_EXPONENT
          && Math.abs((long) exact.scale()) <= MAX_ROW) {
        return exact.scaleByPowerOfTen(scale).setScale(0, RoundingMode.HALF_UP).longValueExact();
      }
    } catch (ArithmeticException | NumberFormatException noNumber) {
      // Told below.
    }
    invalid = true;
    return Long.MIN_VALUE;
  }

  /** A last row without a line feed is one if it has all columns and time does not go back. */
  @Override
  public boolean decodeLast(ByteBuffer in, long offset, EventPacket out, int maxEvents) {
    int length = in.remaining();
    if (length >= MAX_ROW || inLongRow) {
      return false;
    }
    in.get(in.position(), piece, 0, length);
    piece[length] = '\n';
    cursor = 0;
    boolean whole = parseRow() && address >= 0 && timeUs >= lastUs;
    if (whole) {
      lastUs = timeUs;
      out.append(timeUs, address);
      in.position(in.limit());
    }
    return whole;
  }

  @Override
  public long lastUs() {
    return lastUs;
  }

  @Override
  public long restartUs() {
    return restartUs;
  }

  @Override
  public void acceptRestart() {
    if (!restarted) {
      throw new IllegalStateException("the clock did not go back");
    }
    restarted = false;
    lastUs = StreamNotification.NO_TIME_US;
  }

  @Override
  public int stateLongs() {
    return 2;
  }

  @Override
  public void save(long[] state, int at) {
    state[at] = lastUs;
    state[at + 1] = inLongRow ? 1 : 0;
  }

  @Override
  public void restore(long[] state, int at) {
    restarted = false;
    lastUs = state[at];
    inLongRow = state[at + 1] != 0;
  }
}
