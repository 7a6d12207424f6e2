package haltere.core.format.internal.bag;

import haltere.core.event.EventPacket;
import java.io.IOException;
import java.io.InputStream;

/** The bags among the tests' resources, which the Python packages rosbags and mcap wrote. */
final class BagResources {
  private BagResources() {}

  /** The events of all of them. */
  static EventPacket events() {
    EventPacket events = new EventPacket(600);
    for (int i = 0; i < 600; i++) {
      events.append(1_700_000_000_000_000L + i * 37, i * 7 % 346, 259 - i * 11 % 260, i % 3 == 0);
    }
    return events;
  }

  /** The bytes of one. */
  static byte[] bytes(String name) throws IOException {
    try (InputStream in = BagResources.class.getResourceAsStream("/bags/" + name)) {
      return in.readAllBytes();
    }
  }
}
