package haltere.core.format.aedat4;

import haltere.core.format.RecordingFile;
import haltere.core.format.ViolationCounts;
import haltere.core.format.packed.DamagedPacketException;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;

/**
 * Unpacks two of three packets ahead of the reader, on a thread and with a file of its own, while
 * the reader unpacks the third and decodes all of them: that keeps two cores busy. It hands over a
 * few packets of bounded size; what is too large, or damaged, the reader does itself.
 *
 * <p>Thread rule: all methods are for the reader's thread.
 */
final class UnpackAhead implements Closeable {
  /** Of so many packets the reader unpacks one. */
  static final int SHARE = 3;

  private static final int SLOTS = 6;
  private static final int MAX_PACKED = 512 * 1024;
  private static final int MAX_UNPACKED = 1024 * 1024;
  private static final long END = -1;

  /** A packet that is handed over. */
  static final class Slot {
    private long position;
    private boolean unpacked;
    private byte[] data = new byte[0];
    private int length;

    /** Where the packet is in the file; below 0 if there is none. */
    long position() {
      return position;
    }

    /** Whether its payload is here. */
    boolean unpacked() {
      return unpacked;
    }

    byte[] data() {
      return data;
    }

    int length() {
      return length;
    }
  }

  private final BlockingQueue<Slot> free = new ArrayBlockingQueue<>(SLOTS);
  private final BlockingQueue<Slot> filled = new ArrayBlockingQueue<>(SLOTS);
  private final Thread thread;

  /**
   * Starts to work.
   *
   * @param path the file
   * @param layout of the file
   * @param stream whose packets are unpacked
   * @param start position of a packet of the stream that the reader unpacks, the first of its share
   */
  UnpackAhead(Path path, Aedat4Cursor.Layout layout, int stream, long start) {
    for (int i = 0; i < SLOTS; i++) {
      free.add(new Slot());
    }
    thread = new Thread(() -> work(path, layout, stream, start), "haltere-unpack");
    thread.setDaemon(true);
    thread.start();
  }

  private void work(Path path, Aedat4Cursor.Layout layout, int stream, long start) {
    try {
      try (RecordingFile file = new RecordingFile(path)) {
        Unpacker unpacker = new Unpacker(file);
        try {
          walk(unpacker, layout.walk(unpacker.window(), new ViolationCounts()), stream, start);
        } finally {
          unpacker.close();
        }
      } catch (IOException | RuntimeException e) {
        // The reader comes to the same place and says what is wrong.
      }
      Slot last = free.take();
      last.position = END;
      filled.put(last);
    } catch (InterruptedException e) {
      // The reader is closed, or went elsewhere.
    }
  }

  private void walk(Unpacker unpacker, PacketWalk walk, int stream, long start)
      throws IOException, InterruptedException {
    walk.moveTo(start);
    for (long number = 0; walk.find(); ) {
      if (walk.stream() != stream || number++ % SHARE == 0) {
        walk.pass();
        continue;
      }
      Slot slot = free.take();
      slot.position = walk.position();
      slot.unpacked = false;
      boolean damaged = false;
      try {
        slot.unpacked = walk.size() <= MAX_PACKED && unpack(unpacker, walk, slot);
      } catch (DamagedPacketException e) {
        damaged = true;
      }
      filled.put(slot);
      if (damaged) {
        walk.passDamaged();
      } else {
        walk.pass();
      }
    }
  }

  /** Returns false for a payload that is too large. */
  private static boolean unpack(Unpacker unpacker, PacketWalk walk, Slot slot)
      throws IOException, DamagedPacketException {
    unpacker.open(walk.payload(), walk.size());
    slot.length = 0;
    do {
      int count = unpacker.to() - unpacker.from();
      int length = slot.length + count;
      if (length > MAX_UNPACKED) {
        return false;
      }
      if (slot.data.length < length) {
        slot.data = Arrays.copyOf(slot.data, Math.min(MAX_UNPACKED, length + length / 2));
      }
      System.arraycopy(unpacker.data(), unpacker.from(), slot.data, slot.length, count);
      slot.length = length;
      unpacker.use(count);
    } while (unpacker.more());
    return true;
  }

  /** The next packet that is not in the reader's share, or null if the thread is interrupted. */
  Slot take() {
    try {
      return filled.take();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return null;
    }
  }

  /** Gives a slot back. */
  void release(Slot slot) {
    free.add(slot);
  }

  @Override
  public void close() {
    thread.interrupt();
  }
}
