package haltere.core.format.internal.bag;

import haltere.core.format.RecordingFile;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.Payload;
import java.io.IOException;

/**
 * The messages of an MCAP file. They are in chunks or, in files without chunks, separate records,
 * each of which is treated as a chunk.
 */
final class McapWalk extends ChunkWalk {
  private static final int MAX_HEADER = 128 * 1024;

  /** Channel, number, time of recording, time of sending. */
  private static final int MESSAGE_HEAD = 22;

  private final McapIndex index;
  private Payload recordsOf;
  private McapRecord inChunk;
  private boolean ended;

  McapWalk(
      RecordingFile file,
      McapIndex index,
      BagTopics topics,
      Wanted wanted,
      ViolationCounts violations) {
    super(file, McapIndex.FIRST_RECORD, index, topics, wanted, violations);
    this.index = index;
  }

  @Override
  boolean nextChunk() throws IOException {
    ended = false;
    while (next < index.end() && !ended) {
      long rest = file.size() - next;
      records.open(next, Math.min(MAX_HEADER, rest));
      try {
        if (openNext(new McapRecord(records), rest)) {
          return true;
        }
      } catch (DamagedPacketException e) {
        damagedBetweenChunks();
      }
    }
    if (!ended || index.cutOff()) {
      violations.addOnce(Violation.CUT_OFF, file.size());
    }
    next = index.end();
    return false;
  }

  /** Returns false if the current record is not a readable chunk. */
  private boolean openNext(McapRecord record, long rest)
      throws IOException, DamagedPacketException {
    record.next();
    long after = next + McapRecord.HEAD_BYTES + record.bytes();
    switch (record.kind()) {
      case McapRecord.DATA_END, McapRecord.FOOTER -> {
        ended = true;
        return false;
      }
      case McapRecord.CHUNK -> {
        record.takeLong();
        record.takeLong();
        long decompressedBytes = record.takeLong();
        record.takeUnsignedInt();
        String compression = record.takeText();
        long bytes = record.takeLong();
        long data = next + McapRecord.HEAD_BYTES + record.bytes() - record.left();
        return openChunk(compression, data, bytes, decompressedBytes);
      }
      case McapRecord.MESSAGE -> {
        return openChunk("", next, McapRecord.HEAD_BYTES + record.bytes(), rest);
      }
      case McapRecord.SCHEMA, McapRecord.CHANNEL -> {
        if (record.bytes() <= MAX_HEADER - McapRecord.HEAD_BYTES) {
          index.schemas().read(record);
        }
      }
      default -> {
        // attachments, indexes and private records
        if (record.kind() > McapRecord.DATA_END && record.kind() < McapRecord.PRIVATE) {
          violations.add(Violation.UNKNOWN_WORD, next);
        }
      }
    }
    if (record.bytes() > rest - McapRecord.HEAD_BYTES) {
      throw new DamagedPacketException("a record that ends too early");
    }
    next = after;
    return false;
  }

  @Override
  boolean nextMessage() throws IOException, DamagedPacketException {
    if (recordsOf != payload()) {
      recordsOf = payload();
      inChunk = new McapRecord(recordsOf);
    }
    McapRecord record = inChunk;
    while (record.next()) {
      long data = recordAt + McapRecord.HEAD_BYTES;
      long after = data + record.bytes();
      switch (record.kind()) {
        case McapRecord.MESSAGE -> {
          topic = topics.get(record.takeUnsignedShort());
          record.takeUnsignedInt();
          recordedNs = record.takeLong();
          record.takeLong();
          if (topic != null && wanted.topic(topic)) {
            messageAt = data + MESSAGE_HEAD;
            messageBytes = record.left();
            return true;
          }
          record.pass();
        }
        case McapRecord.SCHEMA, McapRecord.CHANNEL -> index.schemas().read(record);
        default -> throw new DamagedPacketException("a record of an unknown type in a chunk");
      }
      recordAt = after;
    }
    return false;
  }
}
