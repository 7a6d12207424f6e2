package haltere.core.format.internal.hdf5;

import java.io.IOException;
import java.util.HashMap;
import java.util.Map;

/**
 * Objects of variable length in heaps shared by a file's datasets and attributes. The heap used
 * last is cached.
 *
 * <p>Thread rule: one thread.
 */
final class GlobalHeap {
  private final ContainerFile file;
  private final Map<Integer, byte[]> objects = new HashMap<>();
  private long loaded = ContainerFile.NOWHERE;

  GlobalHeap(ContainerFile file) {
    this.file = file;
  }

  /** A text by its reference; empty if it is longer than allowed. */
  String text(Metadata reference, int maxBytes) throws IOException {
    long length = reference.u4();
    Metadata object = length > maxBytes ? null : object(reference);
    return object == null ? "" : object.text((int) Math.min(length, object.remaining()));
  }

  /** Integers of a list by its reference. */
  long[] list(Metadata reference, ElementType type) throws IOException {
    long length = reference.u4();
    Metadata object = length == 0 ? null : object(reference);
    if (object == null) {
      return new long[0];
    }
    if (length > object.remaining() / type.bytes()) {
      throw reference.problem("a list of " + length + " elements that is longer than its heap");
    }
    long[] values = new long[(int) length];
    for (int i = 0; i < values.length; i++) {
      values[i] = Attributes.number(type, object.bytes(type.bytes())).longValue();
    }
    return values;
  }

  /** The bytes of a reference, read after its length; null for a null reference. */
  private Metadata object(Metadata reference) throws IOException {
    long position = reference.position();
    long index = reference.u4();
    if (index == 0) {
      return null;
    }
    if (position != loaded) {
      load(position);
    }
    byte[] bytes = objects.get((int) index);
    if (bytes == null) {
      throw reference.problem("an object that is not in its heap");
    }
    return new Metadata(file, bytes, 0, bytes.length, file.offsetOf(position));
  }

  private void load(long position) throws IOException {
    objects.clear();
    int frame = 8 + file.lengthBytes();
    Metadata head = file.at(position, frame);
    head.expect("GCOL");
    head.skip(4);
    Metadata heap = file.at(position, head.length());
    heap.skip(frame);
    while (heap.remaining() >= frame) {
      int index = heap.u2();
      heap.skip(6);
      long size = heap.length();
      if (index == 0) {
        break; // the free space
      }
      if (size > heap.remaining()) {
        throw heap.problem("an object that is larger than its heap");
      }
      objects.put(index, heap.bytes((int) size));
      heap.skip(Math.min(heap.remaining(), (8 - size % 8) % 8));
    }
    loaded = position;
  }
}
