package haltere.core.format.internal.reader;

import haltere.core.event.EventPacket;
import haltere.core.format.internal.clock.EventOrder;
import haltere.core.format.internal.decoding.EventCursor;
import haltere.core.stream.StreamNotification;
import java.io.IOException;

/**
 * The decoded packet that has not been fully passed on. It ends when it is full, when the clock
 * goes back, or at the end of the file.
 *
 * <p>Thread rule: one thread.
 */
final class PacketBuffer {
  /** Least number of events between two restarts of a clock on average. */
  private static final int MIN_EVENTS_PER_RESTART = 100;

  /** Restarts of a table in another order than that of time. */
  private static final int MIN_RESTARTS = 100;

  private final EventCursor cursor;
  private final int packetEvents;
  private final EventPacket packet = new EventPacket(0);
  private final EventPacket piece = new EventPacket(0);

  /** Number of decoded events; a handler may change the packet that it receives. */
  private int decoded;

  private final EventOrder order = new EventOrder();

  private int given;
  private long offset;
  private long events;
  private long restarts;
  private boolean restart;
  private boolean atEnd;

  PacketBuffer(EventCursor cursor, int packetEvents) {
    this.cursor = cursor;
    this.packetEvents = packetEvents;
  }

  /** Whether it has events that have not been passed on. */
  boolean hasEvents() {
    return given < decoded;
  }

  /** Time of the first event that has not been passed on. */
  long nextUs() {
    return packet.timeUs(given);
  }

  /** Position in the file, in bytes, where the decoding of the packet began. */
  long offset() {
    return offset;
  }

  /** Whether the clock goes back after the events. */
  boolean isBeforeRestart() {
    return restart;
  }

  /** Decodes the next packet; it stays empty before a restart and at the end. */
  void fill() throws IOException {
    packet.clear();
    decoded = 0;
    given = 0;
    offset = cursor.positionBytes();
    while (packet.size() < packetEvents && !restart && !atEnd) {
      EventCursor.Stop stop = read();
      if (stop == EventCursor.Stop.END) {
        atEnd = true;
      } else if (stop == EventCursor.Stop.CLOCK_WENT_BACK) {
        restart = !order.isLate(cursor.times().restartUs());
        if (!restart) {
          cursor.times().acceptRestart();
        }
      }
    }
    decoded = packet.size();
    events += decoded;
  }

  private EventCursor.Stop read() throws IOException {
    int before = packet.size();
    if (cursor.times().lastUs() >= order.newestUs()) {
      EventCursor.Stop stop = cursor.read(packet, packetEvents);
      order.raise(packet, before);
      return stop;
    }
    piece.clear();
    EventCursor.Stop stop = cursor.read(piece, packetEvents - before);
    order.raise(piece, 0);
    packet.append(piece, 0, piece.size());
    return stop;
  }

  /** Decodes up to the first packet with an event at or after a time, and drops those before. */
  void fillFrom(long timeUs) throws IOException {
    int before;
    do {
      fill();
      before = packet.indexAtOrAfter(timeUs);
    } while (before == packet.size() && !packet.isEmpty());
    int count = packet.size() - before;
    for (int i = 0; i < count; i++) {
      packet.move(before + i, i);
    }
    packet.truncate(count);
    decoded = count;
    offset = cursor.positionBytes();
  }

  /**
   * Removes the events before a time, at least one; {@link Long#MAX_VALUE} for all.
   *
   * @return these events: the packet itself, or a copy if it has others; valid until the next call
   */
  EventPacket take(long beforeUs) {
    int from = given;
    given = beforeUs == Long.MAX_VALUE ? decoded : packet.indexAtOrAfter(beforeUs, from);
    if (from == 0 && given == decoded) {
      return packet;
    }
    piece.clear();
    piece.append(packet, from, given);
    return piece;
  }

  /**
   * Whether the clock goes back so often that the events are in another order than that of time.
   */
  boolean isUnordered() {
    return restarts >= MIN_RESTARTS && events < restarts * MIN_EVENTS_PER_RESTART;
  }

  /** Time of the last decoded event of the segment. */
  long newestUs() {
    return order.newestUs();
  }

  /** Continues after the restart. */
  void acceptRestart() {
    restart = false;
    restarts++;
    order.continueAfter(StreamNotification.NO_TIME_US);
    cursor.times().acceptRestart();
  }

  /** Discards the events after a seek of the cursor to behind an event. */
  void moved(long newestUs, boolean toEnd) {
    order.continueAfter(newestUs);
    decoded = 0;
    given = 0;
    restart = false;
    atEnd = toEnd;
  }
}
