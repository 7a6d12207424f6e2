package haltere.ui.viewer;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.EventSource;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamStarted;
import java.util.SplittableRandom;

/**
 * Events at a constant rate, prepared beforehand so that the source costs next to nothing: five
 * moving blobs and a tenth of noise.
 */
final class BusySource implements EventSource {
  private static final int EVENTS = 1 << 20;
  private static final int PACKET = 4096;

  private final SensorGeometry geometry;
  private final double usPerEvent;
  private final int[] addresses = new int[EVENTS];
  private final EventPacket packet = new EventPacket(PACKET);
  private boolean started;
  private long sent;

  BusySource(SensorGeometry geometry, double millionEps) {
    this.geometry = geometry;
    usPerEvent = 1 / millionEps;
    SplittableRandom random = new SplittableRandom(7);
    for (int i = 0; i < EVENTS; i++) {
      double phase = 2 * Math.PI * i / EVENTS;
      boolean noise = random.nextInt(10) == 0;
      int blob = random.nextInt(5);
      double middleX = 0.5 + 0.35 * Math.cos(phase + blob * 2 * Math.PI / 5);
      double middleY = 0.5 + 0.35 * Math.sin(phase + blob * 2 * Math.PI / 5);
      double x = noise ? random.nextDouble() : middleX + 0.08 * (random.nextDouble() - 0.5);
      double y = noise ? random.nextDouble() : middleY + 0.08 * (random.nextDouble() - 0.5);
      addresses[i] =
          EventAddress.pack(
              (int) (x * geometry.width()), (int) (y * geometry.height()), random.nextBoolean());
    }
  }

  @Override
  public SensorGeometry geometry() {
    return geometry;
  }

  @Override
  public boolean next(StreamHandler handler) {
    if (!started) {
      started = true;
      handler.notified(new StreamStarted(geometry, "busy source"));
      return true;
    }
    packet.clear();
    for (int i = 0; i < PACKET; i++, sent++) {
      packet.append((long) (sent * usPerEvent), addresses[(int) (sent % EVENTS)]);
    }
    handler.packet(packet);
    return true;
  }

  @Override
  public void close() {}
}
