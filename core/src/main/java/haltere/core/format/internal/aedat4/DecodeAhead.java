package haltere.core.format.internal.aedat4;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingFile;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.FileWindow;
import haltere.core.format.internal.compression.LittleEndian;
import haltere.core.stream.internal.Daemon;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/**
 * Decompresses and decodes the next packets of a stream on two threads: its own, and the reader's
 * while it waits. An idle thread takes the next free packet, so that both are busy. A few packets
 * of bounded size are decoded ahead; large or invalid ones are left to the reader.
 *
 * <p>Threads exchange events, not bytes: a decompressor reads its recent output again, which is
 * slow in the cache of another processor.
 *
 * <p>Thread rule: all methods are for the reader's thread.
 */
final class DecodeAhead implements Closeable {
  /** Minimum average packet size for which a second thread is worthwhile. */
  static final int MIN_PACKET_BYTES = 4096;

  /** Bytes to read for the header of a packet that the other thread decompresses. */
  static final int HEADER_WINDOW = 512;

  private static final int SLOTS = 6;
  private static final int MAX_COMPRESSED = 512 * 1024;
  private static final int MAX_EVENTS = 64 * 1024;

  /** A packet and its decoded events. */
  static final class Slot {
    private final EventPacket events = new EventPacket(0);
    private long position;
    private long payload;
    private long size;
    private boolean done;
    private boolean decoded;

    /** File offset of the packet. */
    long position() {
      return position;
    }

    /** Whether its events are decoded. */
    boolean isDecoded() {
      return decoded;
    }

    EventPacket events() {
      return events;
    }
  }

  private final int stream;
  private final EventRun runs;
  private final RecordingFile headers;
  private final PacketWalk walk;
  private final RecordingFile readersFile;
  private final Decompressor readers;
  private final Thread thread;

  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed = lock.newCondition();
  private final Slot[] ring = new Slot[SLOTS];
  private long claimed;
  private long taken;
  private long released;
  private boolean ended;

  /**
   * Starts decoding.
   *
   * @param path the file
   * @param layout of the file
   * @param geometry sensor of the events
   * @param stream whose packets are decoded
   * @param start position of the first packet
   * @throws IOException if the file cannot be reopened
   */
  DecodeAhead(
      Path path, Aedat4Cursor.Layout layout, SensorGeometry geometry, int stream, long start)
      throws IOException {
    this.stream = stream;
    runs = new EventRun(geometry);
    for (int i = 0; i < SLOTS; i++) {
      ring[i] = new Slot();
    }
    headers = new RecordingFile(path);
    try {
      readersFile = new RecordingFile(path);
    } catch (IOException e) {
      headers.close();
      throw e;
    }
    walk = layout.walk(new FileWindow(headers, HEADER_WINDOW), new ViolationCounts());
    walk.moveTo(start);
    readers = new Decompressor(readersFile);
    thread = Daemon.thread(() -> work(path), "haltere-decode");
    thread.start();
  }

  private void work(Path path) {
    try (RecordingFile file = new RecordingFile(path)) {
      Decompressor own = new Decompressor(file);
      try {
        for (Slot slot = waitAndClaim(); slot != null; slot = waitAndClaim()) {
          decode(own, slot);
        }
      } finally {
        own.close();
      }
    } catch (IOException | InterruptedException e) {
      // the reader is closed, has jumped, or reports the same problem
      end();
    }
  }

  private void end() {
    lock.lock();
    try {
      ended = true;
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  private Slot waitAndClaim() throws IOException, InterruptedException {
    lock.lock();
    try {
      while (!ended && claimed - released == SLOTS) {
        changed.await();
      }
      return claim();
    } finally {
      lock.unlock();
    }
  }

  /** The next free packet, or null. */
  private Slot claim() throws IOException {
    while (!ended && walk.find()) {
      if (walk.stream() == stream) {
        Slot slot = ring[(int) (claimed++ % SLOTS)];
        slot.position = walk.position();
        slot.payload = walk.payload();
        slot.size = walk.size();
        slot.done = false;
        walk.pass();
        return slot;
      }
      walk.pass();
    }
    ended = true;
    return null;
  }

  private void decode(Decompressor decompressor, Slot slot) {
    boolean decoded = false;
    try {
      decoded = slot.size <= MAX_COMPRESSED && decodeWhole(decompressor, slot);
    } catch (IOException | DamagedPacketException e) {
      // the reader reports the same problem
    } finally {
      lock.lock();
      try {
        slot.decoded = decoded;
        slot.done = true;
        changed.signalAll();
      } finally {
        lock.unlock();
      }
    }
  }

  private boolean decodeWhole(Decompressor decompressor, Slot slot)
      throws IOException, DamagedPacketException {
    if (decompressor.window().require(slot.payload, (int) slot.size) < 0) {
      return false;
    }
    decompressor.open(slot.payload, slot.size);
    long count = decompressor.events();
    slot.events.clear();
    if (count == 0 || count > MAX_EVENTS) {
      return count == 0;
    }
    int events = (int) count;
    slot.events.ensureCapacity(events);
    if (!decompressor.gather(events * Aedat4Cursor.EVENT_BYTES)) {
      return false;
    }
    long lastUs = LittleEndian.getLong(decompressor.data(), decompressor.from());
    for (int from = 0; from < events; from += Aedat4Cursor.RUN) {
      int run = Math.min(events - from, Aedat4Cursor.RUN);
      if (!runs.decode(decompressor.data(), decompressor.from(), run, lastUs, slot.events)) {
        return false;
      }
      decompressor.use(run * Aedat4Cursor.EVENT_BYTES);
      lastUs = slot.events.lastTimeUs();
    }
    return true;
  }

  /**
   * The next packet. The calling thread decodes packets until it is available.
   *
   * @return a packet, valid until it is released; null if there is none or the thread is
   *     interrupted
   */
  Slot take() {
    try {
      while (true) {
        Slot own;
        lock.lock();
        try {
          Slot next = ring[(int) (taken % SLOTS)];
          if (taken < claimed && next.done) {
            taken++;
            return next;
          }
          own = claimed - released < SLOTS ? claim() : null;
          if (own == null && taken == claimed) {
            return null;
          }
          if (own == null) {
            changed.await();
          }
        } finally {
          lock.unlock();
        }
        if (own != null) {
          decode(readers, own);
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return null;
    } catch (IOException e) {
      return null;
    }
  }

  /** Releases the packet taken last. */
  void release() {
    lock.lock();
    try {
      released++;
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  @Override
  public void close() throws IOException {
    end();
    thread.interrupt();
    readers.close();
    try (headers) {
      readersFile.close();
    }
  }
}
