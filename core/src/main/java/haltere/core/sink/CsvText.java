package haltere.core.sink;

import java.io.IOException;
import java.io.OutputStream;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Bytes of a table that is being written: numbers without a locale, text quoted where it must be.
 */
final class CsvText implements RowFields.Values {
  private static final int FLUSH_AT = 1 << 16;
  private static final long[] POWERS = new long[10];
  private static final int SHORT_DECIMALS = 6;

  static {
    POWERS[0] = 1;
    for (int i = 1; i < POWERS.length; i++) {
      POWERS[i] = POWERS[i - 1] * 10;
    }
  }

  private final OutputStream out;
  private final byte[] digits = new byte[20];
  private byte[] bytes = new byte[4096];
  private int size;

  CsvText(OutputStream out) {
    this.out = out;
  }

  void raw(char ascii) {
    room(1);
    bytes[size++] = (byte) ascii;
  }

  void raw(String ascii) {
    room(ascii.length());
    for (int i = 0; i < ascii.length(); i++) {
      bytes[size++] = (byte) ascii.charAt(i);
    }
  }

  @Override
  public void number(long value) {
    if (value == Long.MIN_VALUE) {
      raw("-9223372036854775808");
      return;
    }
    if (value < 0) {
      raw('-');
    }
    padded(Math.abs(value), 1);
  }

  private void padded(long value, int width) {
    int start = digits.length;
    long rest = value;
    do {
      digits[--start] = (byte) ('0' + rest % 10);
      rest /= 10;
    } while (rest != 0);
    while (digits.length - start < width) {
      digits[--start] = '0';
    }
    int count = digits.length - start;
    room(count);
    System.arraycopy(digits, start, bytes, size, count);
    size += count;
  }

  /** Not-a-number writes nothing. */
  @Override
  public void number(double value, int decimals) {
    if (special(value)) {
      return;
    }
    if (decimals >= 0) {
      fixed(value, decimals);
      return;
    }
    // A number of at most six decimals: the quotient of two exact numbers is rounded once, as a
    // reader of the same digits rounds once, so it reads back the same.
    double scaled = Math.rint(value * POWERS[SHORT_DECIMALS]);
    if (Math.abs(scaled) < 1e15 && scaled / POWERS[SHORT_DECIMALS] == value && value != 0) {
      trimmed((long) scaled);
    } else {
      raw(value == 0 ? "0" : Double.toString(value));
    }
  }

  @Override
  public void number(float value, int decimals) {
    if (special(value)) {
      return;
    }
    if (decimals >= 0) {
      fixed(value, decimals);
    } else if (value == Math.rint(value) && Math.abs(value) < 1e7f) {
      number((long) value);
    } else {
      raw(Float.toString(value));
    }
  }

  private boolean special(double value) {
    if (Double.isInfinite(value)) {
      raw(value > 0 ? "inf" : "-inf");
    }
    return Double.isNaN(value) || Double.isInfinite(value);
  }

  private void trimmed(long millionths) {
    if (millionths < 0) {
      raw('-');
    }
    long rest = Math.abs(millionths);
    padded(rest / POWERS[SHORT_DECIMALS], 1);
    long fraction = rest % POWERS[SHORT_DECIMALS];
    int decimals = SHORT_DECIMALS;
    if (fraction == 0) {
      return;
    }
    while (fraction % 10 == 0) {
      fraction /= 10;
      decimals--;
    }
    raw('.');
    padded(fraction, decimals);
  }

  private void fixed(double value, int decimals) {
    double scaled = Math.rint(Math.abs(value) * POWERS[decimals]);
    if (scaled >= 1e15) {
      raw(new BigDecimal(value).setScale(decimals, RoundingMode.HALF_EVEN).toPlainString());
      return;
    }
    long rest = (long) scaled;
    if (value < 0 && rest != 0) {
      raw('-');
    }
    padded(rest / POWERS[decimals], 1);
    if (decimals > 0) {
      raw('.');
      padded(rest % POWERS[decimals], decimals);
    }
  }

  @Override
  public void flag(boolean value) {
    raw(value ? "true" : "false");
  }

  @Override
  public void nothing() {
    // an empty field
  }

  @Override
  public void text(CharSequence value) {
    String text = value.toString();
    boolean quoted = mustBeQuoted(text);
    byte[] encoded =
        (quoted ? '"' + text.replace("\"", "\"\"") + '"' : text).getBytes(StandardCharsets.UTF_8);
    room(encoded.length);
    System.arraycopy(encoded, 0, bytes, size, encoded.length);
    size += encoded.length;
  }

  private static boolean mustBeQuoted(String text) {
    int length = text.length();
    for (int i = 0; i < length; i++) {
      char c = text.charAt(i);
      if (c == ',' || c == '"' || c == '\n' || c == '\r') {
        return true;
      }
    }
    return length > 0 && (text.charAt(0) == ' ' || text.charAt(length - 1) == ' ');
  }

  private void room(int more) {
    if (size + more > bytes.length) {
      bytes = Arrays.copyOf(bytes, Math.max(bytes.length * 2, size + more));
    }
  }

  /** A line of its own. */
  void comment(String words) throws IOException {
    byte[] encoded = ("# " + words.replace('\n', ' ')).getBytes(StandardCharsets.UTF_8);
    room(encoded.length);
    System.arraycopy(encoded, 0, bytes, size, encoded.length);
    size += encoded.length;
    endLine();
  }

  void endLine() throws IOException {
    raw('\n');
    if (size >= FLUSH_AT) {
      flush();
    }
  }

  void flush() throws IOException {
    out.write(bytes, 0, size);
    size = 0;
  }
}
