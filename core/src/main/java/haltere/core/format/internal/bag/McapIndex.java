package haltere.core.format.internal.bag;

import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.FileWindow;
import haltere.core.format.internal.compression.StoredPayload;
import java.io.IOException;
import java.util.Arrays;

/**
 * The summary at the end of an MCAP file: channels and positions of chunks. Chunks are read in the
 * order of the file; the summary gives all topics and the next chunk after a damaged one.
 */
final class McapIndex implements ChunkList {
  private static final byte[] MAGIC = {(byte) 0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};

  /** Offset of the first record. */
  static final int FIRST_RECORD = MAGIC.length;

  /** The footer with kind and length. */
  static final int FOOTER_BYTES = McapRecord.HEAD_BYTES + 20;

  private final ChunkPositions chunks = new ChunkPositions();
  private final McapSchemas schemas;
  private final long end;
  private boolean cutOff = true;

  private McapIndex(long fileBytes, BagTopics topics) {
    end = fileBytes;
    schemas = new McapSchemas(topics);
  }

  /** The bytes that an MCAP file begins and ends with. */
  static byte[] magic() {
    return MAGIC.clone();
  }

  /** Whether a file begins as MCAP files do. */
  static boolean isMcap(byte[] head) {
    return head.length >= MAGIC.length
        && Arrays.equals(head, 0, MAGIC.length, MAGIC, 0, MAGIC.length);
  }

  /**
   * Reads the summary, if there is one.
   *
   * @param file the bag
   * @param topics receives its topics
   * @param violations counts damage of the summary
   */
  static McapIndex read(RecordingFile file, BagTopics topics, ViolationCounts violations)
      throws IOException {
    if (!isMcap(file.read(0, MAGIC.length))) {
      throw new RecordingProblem(
          file.path(), "it does not start with the signature of MCAP; leave out --format");
    }
    McapIndex index = new McapIndex(file.size(), topics);
    long footerAt = file.size() - MAGIC.length - FOOTER_BYTES;
    if (footerAt < FIRST_RECORD || !isMcap(file.read(file.size() - MAGIC.length, MAGIC.length))) {
      return index;
    }
    index.cutOff = false;
    StoredPayload payload = new StoredPayload(new FileWindow(file));
    payload.open(footerAt, FOOTER_BYTES);
    try {
      McapRecord footer = new McapRecord(payload);
      if (!footer.next() || footer.kind() != McapRecord.FOOTER) {
        throw new DamagedPacketException("no footer");
      }
      long summaryAt = footer.takeLong();
      if (summaryAt == 0) {
        return index;
      }
      if (summaryAt < FIRST_RECORD || summaryAt > footerAt) {
        throw new DamagedPacketException("a summary outside of the file");
      }
      payload.open(summaryAt, footerAt - summaryAt);
      index.readSummary(new McapRecord(payload), summaryAt);
    } catch (DamagedPacketException e) {
      violations.add(Violation.IMPOSSIBLE_LENGTH, footerAt);
    }
    return index;
  }

  private void readSummary(McapRecord record, long summaryAt)
      throws IOException, DamagedPacketException {
    while (record.next()) {
      switch (record.kind()) {
        case McapRecord.SCHEMA, McapRecord.CHANNEL -> schemas.read(record);
        case McapRecord.CHUNK_INDEX -> {
          record.takeLong();
          record.takeLong();
          long position = record.takeLong();
          if (position < FIRST_RECORD || position >= summaryAt) {
            throw new DamagedPacketException("a chunk outside of the file");
          }
          chunks.add(position);
          record.pass();
        }
        default -> record.pass();
      }
    }
  }

  /** The known schemas and channels. */
  McapSchemas schemas() {
    return schemas;
  }

  @Override
  public boolean cutOff() {
    return cutOff;
  }

  @Override
  public long end() {
    return end;
  }

  @Override
  public long chunkAfter(long position) {
    return chunks.after(position, end);
  }
}
