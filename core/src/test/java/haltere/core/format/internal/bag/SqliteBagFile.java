package haltere.core.format.internal.bag;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.testing.EventPackets;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;

/**
 * Puts a ROS 2 bag in SQLite together: a page for each message, and pages that it continues over.
 */
final class SqliteBagFile {
  private static final int PAGE = 512;
  private static final int MESSAGE_EVENTS = 4000;
  private static final int TOPICS_PAGE = 2;
  private static final int MESSAGES_PAGE = 3;

  private final List<ByteBuffer> pages = new ArrayList<>();

  private SqliteBagFile() {}

  private ByteBuffer newPage() {
    ByteBuffer page = ByteBuffer.allocate(PAGE);
    pages.add(page);
    return page;
  }

  private static void varint(ByteArrayOutputStream out, long value) {
    for (int shift = 28; shift > 0; shift -= 7) {
      if (value >>> shift != 0) {
        out.write((int) (value >>> shift & 0x7f | 0x80));
      }
    }
    out.write((int) (value & 0x7f));
  }

  /** A row: numbers are {@code Long}, texts {@code String}, nothing is null. */
  private static byte[] row(Object... values) {
    ByteArrayOutputStream types = new ByteArrayOutputStream();
    ByteArrayOutputStream content = new ByteArrayOutputStream();
    for (Object value : values) {
      if (value == null) {
        varint(types, 0);
      } else if (value instanceof Long number) {
        varint(types, 6);
        content.writeBytes(ByteBuffer.allocate(8).putLong(number).array());
      } else {
        boolean text = value instanceof String;
        byte[] bytes = text ? ((String) value).getBytes(StandardCharsets.UTF_8) : (byte[]) value;
        varint(types, 2L * bytes.length + (text ? 13 : 12));
        content.writeBytes(bytes);
      }
    }
    ByteArrayOutputStream row = new ByteArrayOutputStream();
    varint(row, types.size() + 1);
    row.writeBytes(types.toByteArray());
    row.writeBytes(content.toByteArray());
    return row.toByteArray();
  }

  /** Fills a leaf with rows, which are numbered from some number on. */
  private void leaf(ByteBuffer page, int head, long firstNumber, byte[]... rows) {
    page.put(head, (byte) 13).putShort(head + 3, (short) rows.length);
    int end = PAGE;
    for (int i = 0; i < rows.length; i++) {
      byte[] row = rows[i];
      int local = row.length;
      if (row.length > PAGE - 35) {
        int least = (PAGE - 12) * 32 / 255 - 23;
        int most = least + (row.length - least) % (PAGE - 4);
        local = most <= PAGE - 35 ? most : least;
      }
      ByteArrayOutputStream cell = new ByteArrayOutputStream();
      varint(cell, row.length);
      varint(cell, firstNumber + i);
      cell.write(row, 0, local);
      if (local < row.length) {
        cell.writeBytes(ByteBuffer.allocate(4).putInt(pages.size() + 1).array());
        for (int at = local; at < row.length; at += PAGE - 4) {
          ByteBuffer more = newPage();
          int count = Math.min(PAGE - 4, row.length - at);
          more.putInt(at + count < row.length ? pages.size() + 1 : 0).put(row, at, count);
        }
      }
      end -= cell.size();
      page.put(end, cell.toByteArray());
      page.putShort(head + 8 + 2 * i, (short) end);
    }
    page.putShort(head + 5, (short) end);
  }

  /** A bag with the events of packets, and messages of another topic in between. */
  static byte[] of(SensorGeometry sensor, EventPacket... packets) {
    return of(MESSAGE_EVENTS, UnaryOperator.identity(), sensor, packets);
  }

  /** The same with messages of so many events, which are compressed one by one. */
  static byte[] of(
      int messageEvents,
      UnaryOperator<byte[]> compression,
      SensorGeometry sensor,
      EventPacket... packets) {
    SqliteBagFile bag = new SqliteBagFile();
    ByteBuffer first = bag.newPage();
    first.put(SqliteFile.MAGIC.getBytes(StandardCharsets.US_ASCII)).putShort((short) PAGE);
    first.putInt(56, 1);
    ByteBuffer topics = bag.newPage();
    ByteBuffer root = bag.newPage();
    bag.leaf(
        first,
        100,
        1,
        row("table", "topics", "topics", (long) TOPICS_PAGE, "CREATE TABLE topics"),
        row("index", "messages", "messages", 9L, "CREATE INDEX messages"),
        row("table", "messages", "messages", (long) MESSAGES_PAGE, "CREATE TABLE messages"));
    bag.leaf(
        topics,
        0,
        1,
        row(null, "/talk", "std_msgs/msg/String", "cdr", ""),
        row(null, "/dvs/events", "dvs_msgs/msg/EventArray", "cdr", ""));
    List<byte[]> messages = new ArrayList<>();
    EventPacket events = new EventPacket(0);
    for (EventPacket packet : packets) {
      events.append(packet, 0, packet.size());
    }
    for (int from = 0; from < events.size(); from += messageEvents) {
      EventPacket part =
          EventPackets.part(events, from, Math.min(from + messageEvents, events.size()));
      messages.add(row(null, 1L, 5L, new RosBytes(true).text("nothing").toBytes()));
      messages.add(row(null, 2L, 6L, compression.apply(RosBytes.array(true, sensor, part))));
    }
    if (messages.isEmpty()) {
      bag.leaf(root, 0, 1);
    } else {
      bag.inner(root, messages);
    }
    first.putInt(28, bag.pages.size());
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    bag.pages.forEach(page -> all.writeBytes(page.array()));
    return all.toByteArray();
  }

  private void inner(ByteBuffer root, List<byte[]> messages) {
    int end = PAGE;
    root.put(0, (byte) 5).putShort(3, (short) (messages.size() - 1));
    for (int i = 0; i < messages.size(); i++) {
      int number = pages.size() + 1;
      leaf(newPage(), 0, 10L + i, messages.get(i));
      if (i == messages.size() - 1) {
        root.putInt(8, number);
        break;
      }
      ByteArrayOutputStream cell = new ByteArrayOutputStream();
      cell.writeBytes(ByteBuffer.allocate(4).putInt(number).array());
      varint(cell, 10 + i);
      end -= cell.size();
      root.put(end, cell.toByteArray()).putShort(12 + 2 * i, (short) end);
    }
    root.putShort(5, (short) end);
  }
}
