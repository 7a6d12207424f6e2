package haltere.core.format.internal.bag;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** Puts a ROS 1 bag together, chunks not compressed. */
final class RosbagFile {
  private static final int BAG_RECORD = 4096;

  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
  private final ByteArrayOutputStream chunk = new ByteArrayOutputStream();
  private final List<byte[]> connections = new ArrayList<>();
  private final List<Integer> chunks = new ArrayList<>();

  RosbagFile() {
    bytes.writeBytes(RosbagIndex.MAGIC.getBytes(StandardCharsets.US_ASCII));
    bytes.writeBytes(bagRecord(0));
  }

  private static byte[] number(long value, int size) {
    byte[] all = ByteBuffer.allocate(8).order(ByteOrder.LITTLE_ENDIAN).putLong(value).array();
    return java.util.Arrays.copyOf(all, size);
  }

  private static byte[] join(byte[]... parts) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    for (byte[] part : parts) {
      all.writeBytes(part);
    }
    return all.toByteArray();
  }

  static byte[] field(String name, byte[] value) {
    byte[] named = join((name + "=").getBytes(StandardCharsets.US_ASCII), value);
    return join(number(named.length, 4), named);
  }

  private static byte[] text(String name, String value) {
    return field(name, value.getBytes(StandardCharsets.US_ASCII));
  }

  private static byte[] op(int kind) {
    return field("op", new byte[] {(byte) kind});
  }

  static byte[] record(byte[] header, byte[] data) {
    return join(number(header.length, 4), header, number(data.length, 4), data);
  }

  private byte[] bagRecord(long indexAt) {
    byte[] header =
        join(
            op(RosbagRecord.BAG),
            field("index_pos", number(indexAt, 8)),
            field("conn_count", number(connections.size(), 4)),
            field("chunk_count", number(chunks.size(), 4)));
    byte[] filling = new byte[BAG_RECORD - 8 - header.length];
    java.util.Arrays.fill(filling, (byte) ' ');
    return record(header, filling);
  }

  /** Adds a topic; its number is how many there were before. */
  RosbagFile topic(String name, String type) {
    byte[] record =
        record(
            join(
                op(RosbagRecord.CONNECTION),
                field("conn", number(connections.size(), 4)),
                text("topic", name)),
            join(
                text("topic", name),
                text("type", type),
                text("md5sum", "*"),
                text("message_definition", "# as it is known\n")));
    connections.add(record);
    chunk.writeBytes(record);
    return this;
  }

  RosbagFile message(int topic, byte[] message) {
    chunk.writeBytes(
        record(
            join(
                op(RosbagRecord.MESSAGE),
                field("conn", number(topic, 4)),
                field("time", number(1_700_000_000, 8))),
            message));
    return this;
  }

  RosbagFile endChunk() {
    return chunk("none", chunk.toByteArray(), chunk.size());
  }

  /** Puts in a chunk that is compressed already. */
  RosbagFile chunk(String compression, byte[] compressed, int decompressedBytes) {
    chunks.add(bytes.size());
    bytes.writeBytes(
        record(
            join(
                op(RosbagRecord.CHUNK),
                text("compression", compression),
                field("size", number(decompressedBytes, 4))),
            compressed));
    chunk.reset();
    bytes.writeBytes(
        record(
            join(
                op(RosbagRecord.INDEX),
                field("ver", number(1, 4)),
                field("conn", number(0, 4)),
                field("count", number(1, 4))),
            new byte[12]));
    return this;
  }

  /** The bag as it is while it is recorded. */
  byte[] open() {
    return bytes.toByteArray();
  }

  /** The bag with its index. */
  byte[] closed() {
    int indexAt = bytes.size();
    connections.forEach(bytes::writeBytes);
    for (int chunkAt : chunks) {
      bytes.writeBytes(
          record(
              join(
                  op(RosbagRecord.CHUNK_INFO),
                  field("ver", number(1, 4)),
                  field("chunk_pos", number(chunkAt, 8)),
                  field("count", number(1, 4))),
              join(number(0, 4), number(1, 4))));
    }
    byte[] all = bytes.toByteArray();
    byte[] first = bagRecord(indexAt);
    System.arraycopy(first, 0, all, RosbagIndex.FIRST_RECORD, first.length);
    return all;
  }

  /** Offset of the first chunk. */
  List<Integer> chunks() {
    return chunks;
  }
}
