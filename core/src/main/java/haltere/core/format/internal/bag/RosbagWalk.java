package haltere.core.format.internal.bag;

import haltere.core.format.RecordingFile;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.compression.DamagedPacketException;
import java.io.IOException;

/**
 * The messages of a ROS 1 bag. They are in separately compressed chunks, together with their
 * connections; indexes between chunks are skipped.
 */
final class RosbagWalk extends ChunkWalk {
  private static final int MAX_HEADER = 64 * 1024 + 8;

  private final RosbagIndex index;

  RosbagWalk(
      RecordingFile file,
      RosbagIndex index,
      BagTopics topics,
      Wanted wanted,
      ViolationCounts violations) {
    super(file, RosbagIndex.FIRST_RECORD, index, topics, wanted, violations);
    this.index = index;
  }

  @Override
  boolean nextChunk() throws IOException {
    while (next < index.end()) {
      records.open(next, Math.min(MAX_HEADER, file.size() - next));
      try {
        RosbagRecord record = RosbagRecord.read(records);
        int kind = record == null ? -1 : record.kind();
        if (kind < RosbagRecord.MESSAGE || kind > RosbagRecord.CONNECTION) {
          throw new DamagedPacketException("a record of an unknown type");
        }
        long data = next + record.headerBytes();
        if (kind == RosbagRecord.CHUNK) {
          String compression = record.fields().getText("compression");
          long decompressedBytes = record.fields().getUnsignedInt("size");
          if (openChunk(compression, data, record.dataBytes(), decompressedBytes)) {
            return true;
          }
          continue;
        }
        if (record.dataBytes() > file.size() - data) {
          throw new DamagedPacketException("a record that ends too early");
        }
        next = data + record.dataBytes();
      } catch (DamagedPacketException e) {
        damagedBetweenChunks();
      }
    }
    if (index.cutOff()) {
      violations.addOnce(Violation.CUT_OFF, file.size());
    }
    return false;
  }

  @Override
  boolean nextMessage() throws IOException, DamagedPacketException {
    for (RosbagRecord record; (record = RosbagRecord.read(payload())) != null; ) {
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
          payload().skip(record.dataBytes());
        }
        case RosbagRecord.CONNECTION -> record.readConnection(payload(), topics);
        default -> throw new DamagedPacketException("a record of an unknown type in a chunk");
      }
      recordAt = data + record.dataBytes();
    }
    return false;
  }
}
