package haltere.device.simulated;

import haltere.core.camera.RegionOfInterest.Region;
import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.simulation.Scene;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Optional;

/**
 * Buffers the events of a scene until they are due.
 *
 * <p>Times are microseconds since the beginning of the scene. Thread rule: one thread at a time.
 */
final class SimulatedSensor {
  /** Duration of silence after an empty packet of a scene. */
  private static final long SILENCE_US = 1_000_000;

  private final Scene<?> scene;
  private final EventPacket ahead = new EventPacket(4096);
  private int index;
  private long coveredUs;
  private boolean over;
  private Optional<Region> region = Optional.empty();

  private final StreamHandler consumer =
      new StreamHandler() {
        @Override
        public void packet(EventPacket packet) {
          ahead.clear();
          index = 0;
          if (packet.isEmpty()) {
            coveredUs += SILENCE_US;
          } else {
            ahead.append(packet, 0, packet.size());
            coveredUs = packet.lastTimeUs() - scene.startUs();
          }
        }

        @Override
        public void notified(StreamNotification notification) {
          over |= notification instanceof EndOfStream;
        }
      };

  SimulatedSensor(Scene<?> scene) {
    this.scene = scene;
  }

  /** Whether the scene has ended and all its events are taken. */
  boolean isOver() {
    return over && index == ahead.size();
  }

  Optional<Region> region() {
    return region;
  }

  void setRegion(Optional<Region> newRegion) {
    region = newRegion;
  }

  /**
   * Takes the events before a time.
   *
   * @param untilUs not before that of the last call
   * @param zeroUs time of 0 on the camera's clock
   * @param out receives them on the camera's clock, appended
   */
  void takeUntil(long untilUs, long zeroUs, EventPacket out) {
    long offsetUs = scene.startUs() + zeroUs;
    while (true) {
      while (index < ahead.size() && ahead.timeUs(index) - scene.startUs() < untilUs) {
        int address = ahead.address(index);
        if (region.isEmpty() || contains(region.get(), address)) {
          out.append(ahead.timeUs(index) - offsetUs, address);
        }
        index++;
      }
      if (index < ahead.size() || over || coveredUs >= untilUs) {
        return;
      }
      try {
        scene.next(consumer);
      } catch (IOException impossible) {
        throw new UncheckedIOException(impossible);
      }
    }
  }

  private static boolean contains(Region region, int address) {
    int x = EventAddress.x(address) - region.left();
    int y = EventAddress.y(address) - region.bottom();
    return x >= 0 && x < region.width() && y >= 0 && y < region.height();
  }
}
