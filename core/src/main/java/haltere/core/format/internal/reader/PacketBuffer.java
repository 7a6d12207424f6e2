package haltere.core.format.internal.reader;

import haltere.core.event.EventPacket;
import haltere.core.format.internal.decoding.EventCursor;
import java.io.IOException;

/**
 * The packet that is decoded and not yet handed over, as a whole or in pieces. It ends where it is
 * full, where the clock goes back, or where the file ends.
 *
 * <p>Thread rule: one thread.
 */
final class PacketBuffer {
  private final EventCursor cursor;
  private final int packetEvents;
  private final EventPacket packet = new EventPacket(0);
  private final EventPacket piece = new EventPacket(0);

  /** Events that were decoded; a handler may change the packet that it is given. */
  private int decoded;

  private int given;
  private long offset;
  private boolean restart;
  private boolean atEnd;

  PacketBuffer(EventCursor cursor, int packetEvents) {
    this.cursor = cursor;
    this.packetEvents = packetEvents;
  }

  /** Whether it holds events that are not handed over. */
  boolean hasEvents() {
    return given < decoded;
  }

  /** Time of the first event that is not handed over. */
  long nextUs() {
    return packet.timeUs(given);
  }

  /** Position in the file, in bytes, where the decoding of the packet began. */
  long offset() {
    return offset;
  }

  /** Whether the clock goes back behind the events. */
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
      switch (cursor.read(packet, packetEvents)) {
        case CLOCK_WENT_BACK -> restart = true;
        case END -> atEnd = true;
        default -> {
          // It has read a piece and continues.
        }
      }
    }
    decoded = packet.size();
  }

  /** Decodes up to the first packet with an event at or after a time, and drops those before. */
  void fillFrom(long timeUs) throws IOException {
    int before;
    do {
      fill();
      before = packet.indexAtOrAfter(timeUs);
    } while (before == packet.size() && !packet.isEmpty());
    int kept = packet.size() - before;
    for (int i = 0; i < kept; i++) {
      packet.move(before + i, i);
    }
    packet.truncate(kept);
    decoded = kept;
    offset = cursor.positionBytes();
  }

  /**
   * Marks the events before a time as handed over, at least one; {@link Long#MAX_VALUE} for all.
   *
   * @return them: the packet itself, or a copy where it holds others; valid until the next call
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

  /** Goes on behind the restart. */
  void acceptRestart() {
    restart = false;
    cursor.times().acceptRestart();
  }

  /** Forgets the events: the cursor is somewhere else. */
  void moved(boolean toEnd) {
    decoded = 0;
    given = 0;
    restart = false;
    atEnd = toEnd;
  }
}
