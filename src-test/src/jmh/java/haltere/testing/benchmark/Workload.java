package haltere.testing.benchmark;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.Recordings;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import haltere.core.stream.EventSource;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.testing.EventPackets;
import haltere.testing.Recorded;
import java.io.IOException;
import java.util.SplittableRandom;

/**
 * The event streams that filters are measured on, handed out in packets that are filled anew each
 * time, because filters work in place.
 */
final class Workload {
  /** Events of one packet, about what a camera sends in a millisecond or a few. */
  static final int PACKET_EVENTS = 4096;

  /** Length of a stream: enough that nothing but the sensor's size decides what fits a cache. */
  private static final int STREAM_EVENTS = 1 << 20;

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
   * @param name {@code noise-320x240} (uniform, the worst case for a branch predictor and a cache),
   *     {@code bars-320x240} (clustered in space and time), {@code fly} (the simulated fly), {@code
   *     discs-320x240} and {@code noisydiscs-320x240} (twenty discs, the latter with as many events
   *     of noise), or the file name of a recording in the folder that the environment variable
   *     HALTERE_RECORDINGS names, which is repeated
   */
  static Workload named(String name) throws IOException {
    if (name.startsWith("noise-")) {
      SensorGeometry geometry = size(name);
      return new Workload(geometry, EventPackets.uniform(geometry, 1, STREAM_EVENTS, 0, 0.5));
    }
    if (name.startsWith("bars-")) {
      SensorGeometry geometry = size(name);
      long durationUs = 150_000L * STREAM_EVENTS / geometry.pixels();
      return new Workload(geometry, EventPackets.movingBars(geometry, 1, durationUs, 0));
    }
    if (name.startsWith("discs-")) {
      return new Workload(size(name), discs(size(name), 0));
    }
    if (name.startsWith("noisydiscs-")) {
      return new Workload(size(name), discs(size(name), 0.5));
    }
    EventSource source =
        name.equals("fly")
            ? new FlyScene(FlySceneSettings.defaults().with("run.durationS=2"))
            : Recordings.open(Recorded.folder().resolve(name));
    try (source) {
      return new Workload(source.geometry(), repeated(read(source)));
    }
  }

  /** All events of a source. */
  static Workload of(EventSource source) throws IOException {
    return new Workload(source.geometry(), read(source));
  }

  /** The same events once more, from their beginning. */
  Workload again() {
    return new Workload(geometry, stream);
  }

  private static SensorGeometry size(String name) {
    String[] size = name.substring(name.indexOf('-') + 1).split("x");
    return new SensorGeometry(Integer.parseInt(size[0]), Integer.parseInt(size[1]));
  }

  /** Twenty discs on circles at 5 million events a second, a share of which is noise. */
  private static EventPacket discs(SensorGeometry geometry, double noise) {
    SplittableRandom random = new SplittableRandom(1);
    EventPacket events = new EventPacket(STREAM_EVENTS);
    double disc = geometry.width() / 60.0;
    double circle = Math.min(geometry.width(), geometry.height()) / 16.0;
    for (int i = 0; i < STREAM_EVENTS; i++) {
      long timeUs = i / 5;
      int x = random.nextInt(geometry.width());
      int y = random.nextInt(geometry.height());
      boolean on = random.nextBoolean();
      if (random.nextDouble() >= noise) {
        int which = random.nextInt(20);
        double turn = which + timeUs * 2e-6;
        double side = random.nextDouble(2 * Math.PI);
        double middleX = geometry.width() * (0.1 + 0.2 * (which % 5));
        double middleY = geometry.height() * (0.125 + 0.25 * (which / 5));
        x = (int) Math.round(middleX + circle * Math.cos(turn) + disc * Math.cos(side));
        y = (int) Math.round(middleY + circle * Math.sin(turn) + disc * Math.sin(side));
        on = Math.sin(side - turn) < 0;
      }
      events.append(timeUs, x, y, on);
    }
    return events;
  }

  private static EventPacket read(EventSource source) throws IOException {
    EventPacket events = new EventPacket(STREAM_EVENTS);
    source.drainTo(
        new StreamHandler() {
          @Override
          public void packet(EventPacket packet) {
            events.append(packet, 0, packet.size());
          }

          @Override
          public void notified(StreamNotification notification) {
            // The benchmarks run on recordings in one piece.
          }
        });
    return events;
  }

  private static EventPacket repeated(EventPacket once) {
    EventPacket stream = EventPackets.copy(once);
    while (stream.size() < STREAM_EVENTS) {
      long shiftUs = stream.lastTimeUs() + 1000 - once.firstTimeUs();
      stream.append(EventPackets.shifted(once, shiftUs), 0, once.size());
    }
    return stream;
  }

  /** Whether the next packet is the first one: time goes back before it. */
  boolean atStart() {
    return next == 0;
  }

  /** The next packet. */
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
