package haltere.core.format.internal.hdf5;

import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.LittleEndian;

/**
 * Decompresses Prophesee's ECF (event compression format, HDF5 filter 36559) to the structures that
 * it is made for: x, y and the polarity of 16 bits each, two unused bytes, and the time of 64 bits.
 *
 * <p>A block begins with 32 bits: the number of events times 4, plus 2 if y, x and polarities are
 * packed together, or plus 1 if x and polarities are. Numbers are little-endian.
 *
 * <ul>
 *   <li><i>Times</i>: the first one, then bytes. The upper half is a step, the lower half the
 *       number of events after it, 15 for a number of 16 bits in the next bytes. An upper half of
 *       15 has four bits of a longer step below it, the lowest ones first.
 *   <li><i>Rows</i>: words with y above 5 bits of the number of events, 31 for a number in the next
 *       word.
 *   <li><i>Columns</i>: words with x above a mask of events in the next five columns, the next one
 *       in the highest bit. <i>Polarities</i>: bytes with the polarity above 7 bits of the number
 *       of events, 127 for a number of 16 bits in the next bytes.
 *   <li><i>Packed</i>: four events in three words. The high bits of each word are those of one
 *       event, the low bits those of the next one that the next words do not hold.
 * </ul>
 */
final class EcfBlock {
  /** Bytes of the structure of an event. */
  static final int EVENT_BYTES = 16;

  private static final int Y = 2;
  private static final int POLARITY = 4;
  private static final int TIME = 8;
  private static final int GROUP = 4;
  private static final int MAX_EVENTS = 0xffff;
  private static final int LONG_STEP = 15;

  private final byte[] in;
  private final int end;
  private final byte[] out;
  private int at;
  private int events;

  private EcfBlock(byte[] in, int end, byte[] out) {
    this.in = in;
    this.end = end;
    this.out = out;
  }

  /** Decompresses a block; returns the end of the bytes. */
  static int unpack(byte[] in, int length, byte[] out, int maxBytes) throws DamagedPacketException {
    return new EcfBlock(in, length, out).unpack(maxBytes);
  }

  private int unpack(int maxBytes) throws DamagedPacketException {
    int head = (int) next(Integer.BYTES);
    events = head >>> 2;
    if (events > MAX_EVENTS || events * EVENT_BYTES > maxBytes) {
      throw new DamagedPacketException("a chunk of " + events + " events");
    }
    if (events == 0) {
      return 0;
    }
    times();
    if ((head & 2) != 0) {
      packed(12, true);
    } else {
      rows();
      if ((head & 1) != 0) {
        packed(0, false);
      } else {
        columns();
        polarities();
      }
    }
    return events * EVENT_BYTES;
  }

  /** The next number of some bytes. */
  private long next(int bytes) throws DamagedPacketException {
    if (bytes > end - at) {
      throw new DamagedPacketException("a chunk that ends too early");
    }
    long number = 0;
    for (int i = 0; i < bytes; i++) {
      number |= (in[at++] & 0xffL) << 8 * i;
    }
    return number;
  }

  private void requireRoom(int event, int count) throws DamagedPacketException {
    if (count > events - event) {
      throw new DamagedPacketException("a chunk with more events than it says");
    }
  }

  private void times() throws DamagedPacketException {
    long timeUs = next(Long.BYTES);
    for (int i = 0; i < events; ) {
      int code = (int) next(1);
      if (code >>> 4 == LONG_STEP) {
        long step = 0;
        int bits = 0;
        for (; code >>> 4 == LONG_STEP; bits += 4) {
          step |= bits < Long.SIZE ? (code & 15L) << bits : 0;
          code = (int) next(1);
        }
        timeUs += step;
      }
      timeUs += code >>> 4;
      int count = (code & 15) == 15 ? (int) next(Short.BYTES) : code & 15;
      requireRoom(i, count);
      for (int last = i + count; i < last; i++) {
        LittleEndian.putLong(out, i * EVENT_BYTES + TIME, timeUs);
      }
    }
  }

  private void rows() throws DamagedPacketException {
    for (int i = 0; i < events; ) {
      int word = (int) next(Short.BYTES);
      int count = (word & 31) == 31 ? (int) next(Short.BYTES) : word & 31;
      requireRoom(i, count);
      for (int last = i + count; i < last; i++) {
        LittleEndian.putShort(out, i * EVENT_BYTES + Y, word >>> 5);
      }
    }
  }

  private void columns() throws DamagedPacketException {
    for (int i = 0; i < events; ) {
      int word = (int) next(Short.BYTES);
      int mask = 32 | word & 31;
      // the last mask may have events of the encoder's last block
      for (int k = 0; k <= 5 && i < events; k++) {
        if ((mask & 32 >> k) != 0) {
          LittleEndian.putShort(out, i++ * EVENT_BYTES, (word >>> 5) + k);
        }
      }
    }
  }

  private void polarities() throws DamagedPacketException {
    for (int i = 0; i < events; ) {
      int code = (int) next(1);
      int count = (code & 127) == 127 ? (int) next(Short.BYTES) : code & 127;
      requireRoom(i, count);
      for (int last = i + count; i < last; i++) {
        LittleEndian.putShort(out, i * EVENT_BYTES + POLARITY, code >>> 7);
      }
    }
  }

  /** Reads groups of events: x above the polarity, with y above both if there is one. */
  private void packed(int rowShift, boolean withRows) throws DamagedPacketException {
    int wordBytes = withRows ? Integer.BYTES : Short.BYTES;
    int part = 2 * wordBytes;
    int bits = 3 * part;
    long mask = (1L << bits) - 1;
    for (int i = 0; i < events; i += GROUP) {
      long first = next(wordBytes);
      long second = next(wordBytes);
      long third = next(wordBytes);
      event(i, first >>> part, rowShift);
      event(i + 1, first & (1L << part) - 1 | second >>> 2 * part << part, rowShift);
      event(i + 2, second & (1L << 2 * part) - 1 | third >>> bits << 2 * part, rowShift);
      event(i + 3, third & mask, rowShift);
    }
  }

  private void event(int i, long packed, int rowShift) {
    if (i >= events) {
      return;
    }
    int to = i * EVENT_BYTES;
    LittleEndian.putShort(out, to, (int) (packed >>> 1) & 0x7ff);
    LittleEndian.putShort(out, to + POLARITY, (int) packed & 1);
    if (rowShift > 0) {
      LittleEndian.putShort(out, to + Y, (int) (packed >>> rowShift) & 0x7ff);
    }
  }
}
