package haltere.core.format.internal.bag;

import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.FileWindow;
import haltere.core.format.internal.compression.Payload;
import haltere.core.format.internal.compression.StoredPayload;
import java.io.IOException;
import java.nio.charset.StandardCharsets;

/**
 * The index at the end of a closed ROS 1 bag: connections and positions of chunks. Chunks are read
 * in the order of the file; the index gives all topics and the next chunk after a damaged one.
 *
 * <p>Thread rule: immutable once read.
 */
final class RosbagIndex implements ChunkList {
  /** The line that a bag begins with. */
  static final String MAGIC = "#ROSBAG V2.0\n";

  /** Offset of the first record. */
  static final int FIRST_RECORD = MAGIC.length();

  private final long fileBytes;
  private long end;
  private boolean cutOff;
  private final ChunkPositions chunks = new ChunkPositions();

  private RosbagIndex(long fileBytes) {
    this.fileBytes = fileBytes;
    end = fileBytes;
  }

  /**
   * Reads the first record and the index, if it states the position.
   *
   * @param file the bag
   * @param topics receives its connections
   * @param violations counts damage of the index
   */
  static RosbagIndex read(RecordingFile file, BagTopics topics, ViolationCounts violations)
      throws IOException {
    byte[] start = file.read(0, FIRST_RECORD);
    if (!new String(start, StandardCharsets.ISO_8859_1).equals(MAGIC)) {
      throw new RecordingProblem(
          file.path(), "it does not begin with #ROSBAG V2.0; leave out --format");
    }
    RosbagIndex index = new RosbagIndex(file.size());
    StoredPayload payload = new StoredPayload(new FileWindow(file));
    payload.open(FIRST_RECORD, file.size() - FIRST_RECORD);
    long position = -1;
    try {
      RosbagRecord bag = RosbagRecord.read(payload);
      if (bag != null && bag.kind() == RosbagRecord.BAG) {
        position = bag.fields().getLong("index_pos");
      }
    } catch (DamagedPacketException e) {
      // counted during the walk through the records
    }
    if (position > FIRST_RECORD && position <= file.size()) {
      index.readRecords(payload, position, topics, violations);
    } else {
      // 0: the bag was not closed
      if (position > 0) {
        violations.add(Violation.IMPOSSIBLE_LENGTH, FIRST_RECORD);
      }
      index.cutOff = true;
    }
    return index;
  }

  private void readRecords(
      Payload payload, long position, BagTopics topics, ViolationCounts violations)
      throws IOException {
    try {
      payload.open(position, fileBytes - position);
      long at = position;
      for (RosbagRecord record; (record = RosbagRecord.read(payload)) != null; ) {
        at += record.headerBytes() + record.dataBytes();
        if (record.kind() == RosbagRecord.CONNECTION) {
          record.readConnection(payload, topics);
          continue;
        }
        if (record.kind() != RosbagRecord.CHUNK_INFO) {
          throw new DamagedPacketException("no record of an index");
        }
        long chunk = record.fields().getLong("chunk_pos");
        if (chunk < FIRST_RECORD || chunk >= position) {
          throw new DamagedPacketException("a chunk outside of the file");
        }
        chunks.add(chunk);
        payload.skip(record.dataBytes());
      }
      end = position;
    } catch (DamagedPacketException e) {
      violations.add(Violation.IMPOSSIBLE_LENGTH, position);
      cutOff = position >= fileBytes;
    }
  }

  @Override
  public long end() {
    return end;
  }

  @Override
  public boolean cutOff() {
    return cutOff;
  }

  @Override
  public long chunkAfter(long position) {
    return chunks.after(position, end);
  }
}
