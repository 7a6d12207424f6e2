package haltere.core.format.bag;

import haltere.core.format.RecordingFile;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.packed.DamagedPacketException;
import haltere.core.format.packed.FileWindow;
import haltere.core.format.packed.Lz4Payload;
import haltere.core.format.packed.Payload;
import haltere.core.format.packed.StoredPayload;
import java.io.IOException;

/**
 * The messages of a ROS 1 bag. They lie in chunks, each packed by itself, with the connections that
 * they belong to; between chunks are indexes, which are passed over.
 */
final class RosbagWalk implements MessageWalk {
  private static final int LONGEST_HEADER = 64 * 1024 + 8;

  private final RecordingFile file;
  private final RosbagIndex index;
  private final BagTopics topics;
  private final Wanted wanted;
  private final ViolationCounts violations;
  private final FileWindow window;
  private final StoredPayload records;
  private final StoredPayload stored;
  private Lz4Payload lz4;
  private Bzip2Payload bzip2;

  private Payload payload;
  private boolean inChunk;
  private long chunk;
  private long next;
  private long packedAt;
  private long packedBytes;
  private long chunkBytes;
  private boolean cut;

  /** Unpacked bytes of the chunk before the record at hand, and before its data. */
  private long recordAt;

  private long messageAt;
  private long messageBytes;
  private long recordedNs;
  private BagTopic topic;

  RosbagWalk(
      RecordingFile file,
      RosbagIndex index,
      BagTopics topics,
      Wanted wanted,
      ViolationCounts violations) {
    this.file = file;
    this.index = index;
    this.topics = topics;
    this.wanted = wanted;
    this.violations = violations;
    window = new FileWindow(file);
    records = new StoredPayload(window);
    stored = new StoredPayload(window);
    payload = stored;
    next = RosbagIndex.FIRST_RECORD;
  }

  @Override
  public boolean find() throws IOException {
    while (inChunk || nextChunk()) {
      try {
        if (nextMessage()) {
          return true;
        }
      } catch (DamagedPacketException e) {
        damaged(e);
      }
    }
    return false;
  }

  /** Opens the next chunk of the file; false at its end. */
  private boolean nextChunk() throws IOException {
    while (next < index.end()) {
      records.open(next, Math.min(LONGEST_HEADER, file.size() - next));
      try {
        RosbagRecord record = RosbagRecord.read(records);
        int kind = record == null ? -1 : record.kind();
        if (kind < RosbagRecord.MESSAGE || kind > RosbagRecord.CONNECTION) {
          throw new DamagedPacketException("a record of no known kind");
        }
        long data = next + record.headerBytes();
        long rest = file.size() - data;
        if (kind == RosbagRecord.CHUNK) {
          if (openChunk(record, data, rest)) {
            return true;
          }
          continue;
        }
        if (record.dataBytes() > rest) {
          throw new DamagedPacketException("a record that ends too early");
        }
        next = data + record.dataBytes();
      } catch (DamagedPacketException e) {
        long at = next;
        next = index.chunkAfter(at);
        boolean lastOnes = next >= index.end() && file.size() - at < LONGEST_HEADER;
        if (lastOnes) {
          violations.addOnce(Violation.CUT_OFF, at);
        } else {
          violations.add(Violation.LYING_LENGTH, at);
        }
        violations.reached(Math.min(next, file.size()));
      }
    }
    if (index.cutOff()) {
      violations.addOnce(Violation.CUT_OFF, file.size());
    }
    return false;
  }

  /** Returns false if it is damaged from the first byte on. */
  private boolean openChunk(RosbagRecord record, long data, long rest) throws IOException {
    chunk = next;
    packedAt = data;
    cut = record.dataBytes() > rest;
    packedBytes = Math.min(record.dataBytes(), rest);
    chunkBytes = Math.max(1, record.fields().getUnsignedInt("size"));
    recordAt = 0;
    messageAt = 0;
    String packing = record.fields().getText("compression");
    next = cut ? Math.min(index.chunkAfter(chunk), file.size()) : data + packedBytes;
    inChunk = true;
    try {
      payload = unpacking(packing);
      payload.open(packedAt, packedBytes);
    } catch (DamagedPacketException e) {
      damaged(e);
    }
    return inChunk;
  }

  private Payload unpacking(String packing) throws DamagedPacketException {
    switch (packing) {
      case "none" -> {
        return stored;
      }
      case "lz4" -> {
        lz4 = lz4 == null ? new Lz4Payload(window) : lz4;
        return lz4;
      }
      case "bz2" -> {
        bzip2 = bzip2 == null ? new Bzip2Payload(window) : bzip2;
        return bzip2;
      }
      default -> throw new DamagedPacketException("a chunk of no known packing");
    }
  }

  /** Goes on in the chunk up to the next message that is wanted; false at its end. */
  private boolean nextMessage() throws IOException, DamagedPacketException {
    while (true) {
      RosbagRecord record = RosbagRecord.read(payload);
      if (record == null) {
        if (cut) {
          throw new DamagedPacketException("a chunk that ends too early");
        }
        inChunk = false;
        return false;
      }
      long data = recordAt + record.headerBytes();
      switch (record.kind()) {
        case RosbagRecord.MESSAGE -> {
          topic = topics.get(record.fields().getUnsignedInt("conn"));
          if (topic != null && wanted.topic(topic)) {
            messageAt = data;
            messageBytes = record.dataBytes();
            recordedNs = record.fields().getTimeNs("time");
            return true;
          }
          payload.skip(record.dataBytes());
        }
        case RosbagRecord.CONNECTION -> record.readConnection(payload, topics);
        default -> throw new DamagedPacketException("a record of no known kind in a chunk");
      }
      recordAt = data + record.dataBytes();
    }
  }

  @Override
  public BagTopic topic() {
    return topic;
  }

  @Override
  public Payload payload() {
    return payload;
  }

  @Override
  public long size() {
    return messageBytes;
  }

  @Override
  public long recordedNs() {
    return recordedNs;
  }

  @Override
  public long offset(long done) {
    return place(messageAt + done);
  }

  /** Where a byte of the chunk is in the file, or would be if it were not packed. */
  private long place(long at) {
    if (payload == stored) {
      return packedAt + Math.min(at, packedBytes);
    }
    double part = Math.min(1.0, (double) at / chunkBytes);
    return packedAt + (long) (part * packedBytes);
  }

  @Override
  public long position() {
    if (inChunk) {
      return place(recordAt);
    }
    return next < index.end() ? next : file.size();
  }

  @Override
  public void pass(long unused) throws IOException {
    recordAt = messageAt + messageBytes;
    try {
      payload.skip(unused);
    } catch (DamagedPacketException e) {
      damaged(e);
    }
  }

  @Override
  public void damaged(DamagedPacketException damage) {
    long at = place(Math.max(recordAt, messageAt));
    if (cut && next >= file.size()) {
      violations.addOnce(Violation.CUT_OFF, at);
    } else {
      violations.add(cut ? Violation.LYING_LENGTH : Violation.DAMAGED_PACKET, at);
    }
    inChunk = false;
    // A length that was too large leads past chunks that the index knows.
    next = Math.min(next, index.chunkAfter(chunk));
  }

  @Override
  public void save(long[] state, int at) {
    state[at] = inChunk ? chunk : next;
    state[at + 1] = inChunk ? recordAt : 0;
  }

  @Override
  public void restore(long[] state, int at) throws IOException {
    inChunk = false;
    next = state[at];
    long skipped = state[at + 1];
    if (skipped == 0 || !nextChunk()) {
      return;
    }
    try {
      payload.skip(skipped);
      recordAt = skipped;
    } catch (DamagedPacketException e) {
      damaged(e);
    }
  }

  @Override
  public void close() {
    // The file belongs to the reader; nothing else is outside of the heap.
  }
}
