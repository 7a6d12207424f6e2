package haltere.core.format.internal.bag;

import haltere.core.format.internal.compression.DamagedPacketException;
import java.io.IOException;
import java.util.HashMap;
import java.util.Map;

/**
 * The schemas and channels of an MCAP file, which define its topics.
 *
 * <p>Thread rule: one thread.
 */
final class McapSchemas {
  private final Map<Integer, String> types = new HashMap<>();
  private final BagTopics topics;

  McapSchemas(BagTopics topics) {
    this.topics = topics;
  }

  /** Reads a schema or channel; skips any other record. */
  void read(McapRecord record) throws IOException, DamagedPacketException {
    int number = record.takeUnsignedShort();
    if (record.kind() == McapRecord.SCHEMA) {
      types.putIfAbsent(number, record.takeText());
    } else {
      String type = types.getOrDefault(record.takeUnsignedShort(), "");
      String name = record.takeText();
      String encoding = record.takeText();
      boolean known = encoding.equals("cdr") || encoding.equals("ros1");
      topics.add(number, new BagTopic(name, known ? type : encoding, encoding.equals("cdr")));
    }
    record.pass();
  }
}
