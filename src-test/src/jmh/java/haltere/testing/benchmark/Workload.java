package haltere.testing.benchmark;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.testing.EventPackets;

/**
 * The event streams that filters are measured on, and a packet that goes through one again and
 * again.
 */
final class Workload {
  /** Events of one packet, about what a camera sends in a millisecond or a few. */
  static final int PACKET_EVENTS = 4096;

  final SensorGeometry geometry;
  private final EventPacket stream;
  private final EventPacket packet = new EventPacket(PACKET_EVENTS);
  private int next;

  private Workload(SensorGeometry geometry, EventPacket stream) {
    this.geometry = geometry;
    this.stream = stream;
  }

  /**
   * A workload by name.
   *
   * @param name {@code noise} (uniform, the worst case for a branch predictor and a cache) or
   *     {@code bars} (clustered in space and time, as recordings are), then the sensor's size
   */
  static Workload named(String name) {
    String[] parts = name.split("-");
    String[] size = parts[1].split("x");
    SensorGeometry geometry =
        new SensorGeometry(Integer.parseInt(size[0]), Integer.parseInt(size[1]));
    EventPacket stream =
        switch (parts[0]) {
          case "noise" -> EventPackets.uniform(geometry, 1, 1 << 20, 0, 0.5);
            // About a million events.
          case "bars" ->
              EventPackets.movingBars(geometry, 1, 150_000_000_000L / geometry.pixels(), 0);
          default -> throw new IllegalArgumentException("no workload named " + name);
        };
    if (stream.size() < PACKET_EVENTS) {
      throw new IllegalArgumentException(name + " has only " + stream.size() + " events");
    }
    return new Workload(geometry, stream);
  }

  /** Whether the next packet is the first one: time goes back before it. */
  boolean atStart() {
    return next == 0;
  }

  /** The next packet, filled anew: filters work in place. */
  EventPacket nextPacket() {
    packet.clear();
    packet.append(stream, next, next + PACKET_EVENTS);
    next += PACKET_EVENTS;
    if (next + PACKET_EVENTS > stream.size()) {
      next = 0;
    }
    return packet;
  }
}
