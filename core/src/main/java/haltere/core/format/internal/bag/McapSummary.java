package haltere.core.format.internal.bag;

import haltere.core.format.AtomicFile;
import haltere.core.format.internal.compression.LittleEndian;
import haltere.core.format.internal.compression.ZstdPacker;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;
import java.util.zip.CRC32;

/**
 * Writes an MCAP file of one topic around its messages: header, chunks with the indexes of their
 * messages, and the summary, an index of chunks by time. All checksums are written.
 *
 * <p>Thread rule: one thread.
 */
final class McapSummary {
  /** Number of the only channel. */
  static final int CHANNEL = 1;

  private static final int SCHEMA = 1;
  private static final String PACKING = "zstd";
  private static final String RULE = "=".repeat(80) + "\n";
  private static final String DEFINITION =
      "std_msgs/Header header\nuint32 height\nuint32 width\ndvs_msgs/Event[] events\n"
          + RULE
          + "MSG: dvs_msgs/Event\nuint16 x\nuint16 y\nbuiltin_interfaces/Time ts\nbool polarity\n"
          + RULE
          + "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n"
          + RULE
          + "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n";

  private final AtomicFile file;
  private final McapOutput out = new McapOutput();
  private final McapOutput chunkIndexes = new McapOutput();
  private final McapOutput metadataIndex = new McapOutput();
  private final CRC32 checksum = new CRC32();
  private long position;

  private long[] messages = new long[64];
  private int messageCount;
  private long firstNs;
  private long lastNs;
  private byte[] compressed = new byte[0];

  private long allMessages;
  private long chunks;
  private long allFirstNs = Long.MAX_VALUE;
  private long allLastNs;

  /** Writes the start of a file. */
  McapSummary(AtomicFile file, Map<String, String> metadata) throws IOException {
    this.file = file;
    out.raw(McapIndex.magic(), McapIndex.FIRST_RECORD);
    int at = out.start(McapRecord.HEADER);
    out.text("ros2").text("haltere").end(at);
    if (!metadata.isEmpty()) {
      putMetadata(metadata);
    }
    flush();
  }

  private void putMetadata(Map<String, String> metadata) {
    int from = out.size();
    int at = out.start(McapRecord.METADATA);
    McapOutput map = new McapOutput();
    new TreeMap<>(metadata).forEach((key, value) -> map.text(key).text(value));
    out.text("recording").u32(map.size()).raw(map.bytes(), map.size()).end(at);
    int indexAt = metadataIndex.start(McapRecord.METADATA_INDEX);
    metadataIndex.u64(from).u64(out.size() - from).text("recording").end(indexAt);
  }

  private void write(byte[] bytes, int count) throws IOException {
    checksum.update(bytes, 0, count);
    position += count;
    ByteBuffer buffer = ByteBuffer.wrap(bytes, 0, count);
    while (buffer.hasRemaining()) {
      file.write(buffer);
    }
  }

  private void flush() throws IOException {
    write(out.bytes(), out.size());
    out.clear();
  }

  private static void putSchema(McapOutput to) {
    int at = to.start(McapRecord.SCHEMA);
    to.u16(SCHEMA).text("dvs_msgs/msg/EventArray").text("ros2msg").text(DEFINITION).end(at);
  }

  private static void putChannel(McapOutput to) {
    int at = to.start(McapRecord.CHANNEL);
    to.u16(CHANNEL).u16(SCHEMA).text("/dvs/events").text("cdr").u32(0).end(at);
  }

  /** Writes the schema and the channel to a chunk. */
  void putTopic(McapOutput chunk) {
    putSchema(chunk);
    putChannel(chunk);
  }

  /** Adds a message in the current chunk to its index. */
  void message(long timeNs, long offset) {
    if (2 * messageCount == messages.length) {
      messages = Arrays.copyOf(messages, 2 * messages.length);
    }
    firstNs = messageCount == 0 ? timeNs : Math.min(firstNs, timeNs);
    lastNs = messageCount == 0 ? timeNs : Math.max(lastNs, timeNs);
    messages[2 * messageCount] = timeNs;
    messages[2 * messageCount + 1] = offset;
    messageCount++;
  }

  /** Writes a chunk with the index of its messages. */
  void writeChunk(McapOutput chunk, ZstdPacker compressor) throws IOException {
    CRC32 crc = new CRC32();
    crc.update(chunk.bytes(), 0, chunk.size());
    int bound = ZstdPacker.bound(chunk.size());
    if (compressed.length < bound) {
      compressed = new byte[bound];
    }
    int bytes = compressor.pack(chunk.bytes(), chunk.size(), compressed, 0);
    long chunkAt = position;
    int at = out.start(McapRecord.CHUNK);
    out.u64(firstNs).u64(lastNs).u64(chunk.size()).u32(crc.getValue()).text(PACKING);
    out.u64(bytes).raw(compressed, bytes).end(at);
    flush();
    long chunkBytes = position - chunkAt;
    long indexAt = position;
    at = out.start(McapRecord.MESSAGE_INDEX);
    out.u16(CHANNEL).u32(16L * messageCount);
    for (int i = 0; i < 2 * messageCount; i++) {
      out.u64(messages[i]);
    }
    out.end(at);
    flush();
    at = chunkIndexes.start(McapRecord.CHUNK_INDEX);
    chunkIndexes.u64(firstNs).u64(lastNs).u64(chunkAt).u64(chunkBytes);
    chunkIndexes.u32(10).u16(CHANNEL).u64(indexAt).u64(position - indexAt);
    chunkIndexes.text(PACKING).u64(bytes).u64(chunk.size()).end(at);
    chunks++;
    allMessages += messageCount;
    allFirstNs = Math.min(allFirstNs, firstNs);
    allLastNs = Math.max(allLastNs, lastNs);
    messageCount = 0;
  }

  /** Writes the end of a file. */
  void finish() throws IOException {
    if (chunks == 0) {
      putTopic(out);
      flush();
    }
    int at = out.start(McapRecord.DATA_END);
    out.u32(checksum.getValue()).end(at);
    flush();
    long summaryAt = position;
    checksum.reset();
    McapOutput offsets = new McapOutput();
    putSchema(out);
    offset(offsets, McapRecord.SCHEMA, summaryAt);
    long groupAt = summaryAt + out.size();
    putChannel(out);
    offset(offsets, McapRecord.CHANNEL, groupAt);
    groupAt = summaryAt + out.size();
    at = out.start(McapRecord.STATISTICS);
    out.u64(allMessages).u16(1).u32(1).u32(0).u32(metadataIndex.size() > 0 ? 1 : 0).u32(chunks);
    out.u64(chunks == 0 ? 0 : allFirstNs).u64(allLastNs);
    out.u32(10).u16(CHANNEL).u64(allMessages).end(at);
    offset(offsets, McapRecord.STATISTICS, groupAt);
    groupAt = summaryAt + out.size();
    out.raw(chunkIndexes.bytes(), chunkIndexes.size());
    offset(offsets, McapRecord.CHUNK_INDEX, groupAt);
    groupAt = summaryAt + out.size();
    out.raw(metadataIndex.bytes(), metadataIndex.size());
    offset(offsets, McapRecord.METADATA_INDEX, groupAt);
    long offsetsAt = summaryAt + out.size();
    out.raw(offsets.bytes(), offsets.size());
    at = out.start(McapRecord.FOOTER);
    out.u64(summaryAt).u64(offsetsAt);
    // the checksum covers the footer before it, including its length
    out.u32(0).end(at);
    CRC32 crc = new CRC32();
    crc.update(out.bytes(), 0, out.size() - 4);
    LittleEndian.putInt(out.bytes(), out.size() - 4, (int) crc.getValue());
    out.raw(McapIndex.magic(), McapIndex.FIRST_RECORD);
    flush();
  }

  /** Writes the offset of a group of the summary, if it exists. */
  private void offset(McapOutput offsets, int kind, long groupAt) {
    long bytes = position + out.size() - groupAt;
    if (bytes > 0) {
      int at = offsets.start(McapRecord.SUMMARY_OFFSET);
      offsets.u8(kind).u64(groupAt).u64(bytes).end(at);
    }
  }
}
