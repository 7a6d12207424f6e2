package haltere.core.format.internal.csv;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/** Decimal digits, eight at once. */
final class Digits {
  private static final VarHandle EIGHT_BYTES =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);
  private static final long ZEROES = 0x3030303030303030L;
  private static final long HIGH_BITS = 0x8080808080808080L;

  /** Addend that sets the high bit of bytes above 9. */
  private static final long ABOVE_NINE = 0x7676767676767676L;

  /** Maximum number of digits that fit a long. */
  static final int MAX_DIGITS = 18;

  private static final long[] POWERS = new long[MAX_DIGITS + 1];

  static {
    POWERS[0] = 1;
    for (int i = 1; i <= MAX_DIGITS; i++) {
      POWERS[i] = POWERS[i - 1] * 10;
    }
  }

  private Digits() {}

  /** Eight characters minus the character 0, the first of them in the lowest byte. */
  static long digits(byte[] bytes, int at) {
    return (long) EIGHT_BYTES.get(bytes, at) ^ ZEROES;
  }

  /** Number of leading digits. */
  static int count(long digits) {
    return Long.numberOfTrailingZeros((digits + ABOVE_NINE | digits) & HIGH_BITS) >>> 3;
  }

  /** The value of the first digits of eight, at least one. */
  static long value(long digits, int count) {
    long eight = digits << (8 - count << 3);
    long pairs = eight * 10 + (eight >>> 8);
    return (pairs & 0x000000ff000000ffL) * (100 + (1_000_000L << 32))
            + (pairs >>> 16 & 0x000000ff000000ffL) * (1 + (10_000L << 32))
        >>> 32;
  }

  /** Ten to a power. */
  static long power(int exponent) {
    return POWERS[exponent];
  }
}
