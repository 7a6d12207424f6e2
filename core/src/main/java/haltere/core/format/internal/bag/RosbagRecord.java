package haltere.core.format.internal.bag;

import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.LittleEndian;
import haltere.core.format.internal.compression.Payload;
import java.io.IOException;

/**
 * Reads the records of a ROS 1 bag: length and bytes of a header of fields, length and bytes of
 * data.
 */
final class RosbagRecord {
  static final int MESSAGE = 2;
  static final int BAG = 3;
  static final int INDEX = 4;
  static final int CHUNK = 5;
  static final int CHUNK_INFO = 6;
  static final int CONNECTION = 7;

  /** Limit of headers; topic names are not longer than file names. */
  private static final int MAX_HEADER = 64 * 1024;

  private static final int MAX_DESCRIPTION = 1024 * 1024;

  private final RosbagFields fields;
  private final int headerBytes;
  private final long dataBytes;

  private RosbagRecord(RosbagFields fields, int headerBytes, long dataBytes) {
    this.fields = fields;
    this.headerBytes = headerBytes;
    this.dataBytes = dataBytes;
  }

  /**
   * Reads a header.
   *
   * @return the record, or null at the end
   */
  static RosbagRecord read(Payload payload) throws IOException, DamagedPacketException {
    if (!payload.gather(4)) {
      if (payload.from() == payload.to()) {
        return null;
      }
      throw new DamagedPacketException("a record that ends too early");
    }
    int length = LittleEndian.getInt(payload.data(), payload.from());
    if (length < 0 || length > MAX_HEADER) {
      throw new DamagedPacketException("a header of impossible length");
    }
    if (!payload.gather(length + 8)) {
      throw new DamagedPacketException("a record that ends too early");
    }
    byte[] data = payload.data();
    int at = payload.from() + 4;
    RosbagFields fields = new RosbagFields(data, at, at + length);
    long dataBytes = LittleEndian.getInt(data, at + length) & 0xffff_ffffL;
    payload.use(length + 8);
    return new RosbagRecord(fields, length + 8, dataBytes);
  }

  /** Kind of the record; -1 if it is not stated. */
  int kind() {
    return fields.getByte("op");
  }

  /** Its fields, until more of the payload is read. */
  RosbagFields fields() {
    return fields;
  }

  /** Bytes before the data. */
  int headerBytes() {
    return headerBytes;
  }

  long dataBytes() {
    return dataBytes;
  }

  /** Adds the topic of a connection, and skips the record. */
  void readConnection(Payload payload, BagTopics topics)
      throws IOException, DamagedPacketException {
    long number = fields.getUnsignedInt("conn");
    String name = fields.getText("topic");
    if (dataBytes > MAX_DESCRIPTION) {
      payload.skip(dataBytes);
      return;
    }
    int bytes = (int) dataBytes;
    if (!payload.gather(bytes)) {
      throw new DamagedPacketException("a record that ends too early");
    }
    RosbagFields data = new RosbagFields(payload.data(), payload.from(), payload.from() + bytes);
    if (number >= 0) {
      topics.add(number, new BagTopic(name, data.getText("type"), false));
    }
    payload.use(bytes);
  }
}
