package haltere.core.format.internal.compression;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/** Little-endian numbers in a byte array, at any index, in one access each. */
public final class LittleEndian {
  /** Eight bytes; fast loops use it directly. */
  public static final VarHandle LONG =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);

  /** Four bytes. */
  public static final VarHandle INT =
      MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);

  /** Two bytes. */
  public static final VarHandle SHORT =
      MethodHandles.byteArrayViewVarHandle(short[].class, ByteOrder.LITTLE_ENDIAN);

  private LittleEndian() {}

  /**
   * Reads eight bytes.
   *
   * @param bytes the array
   * @param at index of the first of them
   * @return the number
   */
  public static long getLong(byte[] bytes, int at) {
    return (long) LONG.get(bytes, at);
  }

  /**
   * Reads four bytes.
   *
   * @param bytes the array
   * @param at index of the first of them
   * @return the number
   */
  public static int getInt(byte[] bytes, int at) {
    return (int) INT.get(bytes, at);
  }

  /**
   * Reads two bytes.
   *
   * @param bytes the array
   * @param at index of the first of them
   * @return 0 to 65,535
   */
  public static int getUnsignedShort(byte[] bytes, int at) {
    return (short) SHORT.get(bytes, at) & 0xffff;
  }

  /**
   * Writes eight bytes.
   *
   * @param bytes the array
   * @param at index of the first of them
   * @param value the number
   */
  public static void putLong(byte[] bytes, int at, long value) {
    LONG.set(bytes, at, value);
  }

  /**
   * Writes four bytes.
   *
   * @param bytes the array
   * @param at index of the first of them
   * @param value the number
   */
  public static void putInt(byte[] bytes, int at, int value) {
    INT.set(bytes, at, value);
  }

  /**
   * Writes the lower two bytes of a number.
   *
   * @param bytes the array
   * @param at index of the first of them
   * @param value the number
   */
  public static void putShort(byte[] bytes, int at, int value) {
    SHORT.set(bytes, at, (short) value);
  }
}
