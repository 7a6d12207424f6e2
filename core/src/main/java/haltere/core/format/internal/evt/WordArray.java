package haltere.core.format.internal.evt;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/** Words in an array, which is read faster than a buffer. */
final class WordArray {
  private static final VarHandle EIGHT_BYTES =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);

  private WordArray() {}

  /** Eight bytes from an index on, the first of them in the lowest bits. */
  static long eightBytes(byte[] bytes, int index) {
    return (long) EIGHT_BYTES.get(bytes, index);
  }
}
