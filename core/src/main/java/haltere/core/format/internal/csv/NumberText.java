package haltere.core.format.internal.csv;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/**
 * Writes integers as text, each followed by a comma: coordinates from a table, times as the leading
 * digits shared with the previous time and four digits from another table.
 *
 * <p>Thread rule: one thread.
 */
final class NumberText {
  private static final int TABLE = 10_000;
  private static final VarHandle EIGHT_BYTES =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);
  private static final VarHandle FOUR_BYTES =
      MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);

  /** A number without leading zeros and a comma; the number of characters is in the top byte. */
  private static final long[] SHORT = new long[TABLE];

  /** Four digits. */
  private static final int[] FOUR = new int[TABLE];

  static {
    for (int value = 0; value < TABLE; value++) {
      String plain = value + ",";
      long packed = (long) plain.length() << 56;
      for (int i = 0; i < plain.length(); i++) {
        packed |= (long) plain.charAt(i) << 8 * i;
      }
      SHORT[value] = packed;
      String four = String.format(java.util.Locale.ROOT, "%04d", value);
      for (int i = 0; i < 4; i++) {
        FOUR[value] |= four.charAt(i) << 8 * i;
      }
    }
  }

  /** Start of the 10,000 us in which times have the same leading digits. */
  private long sharedFromUs;

  private final byte[] shared = new byte[24];
  private int sharedLength;

  /** Writes a coordinate; returns the index after it. At least 8 bytes must be free. */
  int coordinate(byte[] bytes, int at, int value) {
    if (value >= TABLE) {
      return number(bytes, at, value);
    }
    long packed = SHORT[value];
    EIGHT_BYTES.set(bytes, at, packed);
    return at + (int) (packed >>> 56);
  }

  /** Writes a time; returns the index after it. At least 32 bytes must be free. */
  int time(byte[] bytes, int at, long timeUs) {
    long rest = timeUs - sharedFromUs;
    if (timeUs < sharedFromUs || rest >= TABLE || sharedLength == 0) {
      if (timeUs < TABLE) {
        return number(bytes, at, timeUs);
      }
      share(timeUs / TABLE);
      rest = timeUs - sharedFromUs;
    }
    for (int i = 0; i < sharedLength; i += Long.BYTES) {
      EIGHT_BYTES.set(bytes, at + i, (long) EIGHT_BYTES.get(shared, i));
    }
    int end = at + sharedLength;
    FOUR_BYTES.set(bytes, end, FOUR[(int) rest]);
    bytes[end + 4] = ',';
    return end + 5;
  }

  private void share(long thousands) {
    byte[] text = Long.toString(thousands).getBytes(StandardCharsets.US_ASCII);
    System.arraycopy(text, 0, shared, 0, text.length);
    sharedLength = text.length;
    sharedFromUs = thousands * TABLE;
  }

  private static int number(byte[] bytes, int at, long value) {
    byte[] text = Long.toString(value).getBytes(StandardCharsets.US_ASCII);
    System.arraycopy(text, 0, bytes, at, text.length);
    bytes[at + text.length] = ',';
    return at + text.length + 1;
  }
}
