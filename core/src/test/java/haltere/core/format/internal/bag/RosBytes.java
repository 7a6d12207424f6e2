package haltere.core.format.internal.bag;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/** Puts messages together as ROS 1, or ROS 2 with its alignment, serialises them. */
final class RosBytes {
  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
  private final boolean cdr;

  RosBytes(boolean cdr) {
    this.cdr = cdr;
    if (cdr) {
      raw(0, 1, 0, 0);
    }
  }

  private RosBytes raw(int... values) {
    for (int value : values) {
      bytes.write(value);
    }
    return this;
  }

  private void align(int size) {
    while (cdr && (bytes.size() - 4) % size != 0) {
      bytes.write(0);
    }
  }

  RosBytes u8(int value) {
    return raw(value);
  }

  RosBytes u16(int value) {
    align(2);
    return raw(value, value >>> 8);
  }

  RosBytes u32(long value) {
    align(4);
    return raw((int) value, (int) value >>> 8, (int) value >>> 16, (int) value >>> 24);
  }

  RosBytes u64(long value) {
    align(8);
    bytes.writeBytes(ByteBuffer.allocate(8).order(ByteOrder.LITTLE_ENDIAN).putLong(value).array());
    return this;
  }

  RosBytes text(String text) {
    byte[] utf = (cdr ? text + "\0" : text).getBytes(StandardCharsets.UTF_8);
    u32(utf.length);
    bytes.writeBytes(utf);
    return this;
  }

  RosBytes blob(byte[] blob) {
    u32(blob.length);
    bytes.writeBytes(blob);
    return this;
  }

  RosBytes time(long timeUs) {
    return u32(Math.floorDiv(timeUs, 1_000_000)).u32(Math.floorMod(timeUs, 1_000_000) * 1000L);
  }

  RosBytes header(long timeUs) {
    if (!cdr) {
      u32(7);
    }
    return time(timeUs).text("camera");
  }

  byte[] toBytes() {
    return bytes.toByteArray();
  }

  /** A {@code dvs_msgs/EventArray} with the events of a packet. */
  static byte[] array(boolean cdr, SensorGeometry sensor, EventPacket events) {
    RosBytes message =
        new RosBytes(cdr)
            .header(events.isEmpty() ? 0 : events.firstTimeUs())
            .u32(sensor.height())
            .u32(sensor.width())
            .u32(events.size());
    for (int i = 0; i < events.size(); i++) {
      message
          .u16(events.x(i))
          .u16(sensor.height() - 1 - events.y(i))
          .time(events.timeUs(i))
          .u8(events.isOn(i) ? 1 : 0);
    }
    return message.toBytes();
  }

  /** An {@code event_camera_msgs/EventPacket}. */
  static byte[] packet(
      boolean cdr,
      SensorGeometry sensor,
      long number,
      long baseNs,
      String encoding,
      boolean bigEndian,
      byte[] events) {
    return new RosBytes(cdr)
        .header(0)
        .u32(sensor.height())
        .u32(sensor.width())
        .u64(number)
        .u64(baseNs)
        .text(encoding)
        .u8(bigEndian ? 1 : 0)
        .blob(events)
        .toBytes();
  }
}
