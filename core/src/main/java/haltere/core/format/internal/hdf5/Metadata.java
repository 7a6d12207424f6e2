package haltere.core.format.internal.hdf5;

import haltere.core.format.RecordingProblem;
import java.nio.charset.StandardCharsets;

/**
 * A range of the metadata of a file, read sequentially. Each read is checked against its bounds, so
 * that damage is reported with its offset.
 *
 * <p>Thread rule: one thread.
 */
final class Metadata {
  private final ContainerFile file;
  private final byte[] bytes;
  private final int end;
  private final long address;
  private int at;

  /**
   * A range.
   *
   * @param file defines the sizes of offsets and lengths
   * @param bytes contain it
   * @param from its start
   * @param end its end
   * @param address file offset of the first of the bytes
   */
  Metadata(ContainerFile file, byte[] bytes, int from, int end, long address) {
    this.file = file;
    this.bytes = bytes;
    this.at = from;
    this.end = end;
    this.address = address;
  }

  int remaining() {
    return end - at;
  }

  /** Offset in the file of the next number. */
  long offset() {
    return address + at;
  }

  private int take(long count) throws RecordingProblem {
    if (count < 0 || count > end - at) {
      throw problem("a piece of the file's structure ends too early");
    }
    int start = at;
    at += (int) count;
    return start;
  }

  void skip(long count) throws RecordingProblem {
    take(count);
  }

  /** An unsigned number of 1 to 8 bytes; of 8 bytes, the raw 64 bits. */
  long number(int size) throws RecordingProblem {
    int start = take(size);
    long value = 0;
    for (int i = size - 1; i >= 0; i--) {
      value = value << 8 | bytes[start + i] & 0xff;
    }
    return value;
  }

  int u1() throws RecordingProblem {
    return (int) number(1);
  }

  int u2() throws RecordingProblem {
    return (int) number(2);
  }

  long u4() throws RecordingProblem {
    return number(4);
  }

  /** A position, or {@link ContainerFile#NOWHERE}. */
  long position() throws RecordingProblem {
    return file.position(number(file.offsetBytes()));
  }

  /** A length or count that fits 63 bits. */
  long length() throws RecordingProblem {
    long value = number(file.lengthBytes());
    if (value < 0) {
      throw problem("a length that cannot be true");
    }
    return value;
  }

  /** Some characters, up to the first zero. */
  String text(int size) throws RecordingProblem {
    int start = take(size);
    int stop = start;
    while (stop < start + size && bytes[stop] != 0) {
      stop++;
    }
    return new String(bytes, start, stop - start, StandardCharsets.UTF_8);
  }

  /** Characters up to a zero, which is consumed. */
  String textToZero() throws RecordingProblem {
    int stop = at;
    while (stop < end && bytes[stop] != 0) {
      stop++;
    }
    String text = text(stop - at);
    skip(1);
    return text;
  }

  byte[] bytes(int size) throws RecordingProblem {
    int start = take(size);
    return java.util.Arrays.copyOfRange(bytes, start, start + size);
  }

  /** The next bytes as a range of their own. */
  Metadata part(long size) throws RecordingProblem {
    int start = take(size);
    return new Metadata(file, bytes, start, start + (int) size, address);
  }

  void expect(String signature) throws RecordingProblem {
    if (!text(signature.length()).equals(signature)) {
      throw problem(signature + " is missing here");
    }
  }

  RecordingProblem problem(String message) {
    return new RecordingProblem(
        file.bytes().path(), offset(), "damaged: " + message + "; h5dump or a copy may help");
  }

  /** The problem of valid but unsupported data. */
  RecordingProblem unknown(String what) {
    return file.unknown(offset(), what);
  }
}
