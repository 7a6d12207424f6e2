package haltere.core.format;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import java.io.IOException;

/** How large a sensor must be for the first events of a recording that does not say it. */
public final class SensorGuess {
  private static final int LOOK_EVENTS = 1 << 20;
  private static final int PACKET_EVENTS = 8192;

  private SensorGuess() {}

  /**
   * Reads the first events.
   *
   * @param cursor at the start of the recording, with rows as the file counts them
   * @param origin where the file counts rows from
   * @return the smallest sensor that has all of their pixels
   * @throws IOException if the file cannot be read
   */
  public static SensorGeometry of(EventCursor cursor, Origin origin) throws IOException {
    EventPacket packet = new EventPacket(PACKET_EVENTS);
    int width = 1;
    int height = 1;
    EventCursor.Stop stop = EventCursor.Stop.MORE;
    for (int done = 0;
        done < LOOK_EVENTS && stop != EventCursor.Stop.END;
        done += Math.max(1, packet.size())) {
      packet.clear();
      stop = cursor.read(packet, PACKET_EVENTS);
      if (stop == EventCursor.Stop.CLOCK_WENT_BACK) {
        cursor.acceptRestart();
      }
      for (int i = 0; i < packet.size(); i++) {
        width = Math.max(width, packet.x(i) + 1);
        height = Math.max(height, packet.y(i) + 1);
      }
    }
    return new SensorGeometry(width, height, origin);
  }
}
