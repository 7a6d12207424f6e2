package haltere.filters.noise;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.chain.EventFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.filters.noise.RefractorySettings.Silence;
import haltere.testing.EventFilterContract;
import haltere.testing.EventPackets;
import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;

class RefractoryFilterTest extends EventFilterContract {
  private static final SensorGeometry SENSOR = new SensorGeometry(16, 8);

  @Override
  protected EventFilter create(SensorGeometry geometry) {
    return new RefractoryFilter(geometry, RefractorySettings.defaults());
  }

  @Test
  void firstEventOfEachPixelPasses() {
    EventPacket packet = new EventPacket(0);
    packet.append(0, 3, 3, true);
    packet.append(0, 4, 3, true);
    assertEquals(2, filtered(packet, 1000, Silence.SINCE_LAST_PASSED).size());
  }

  @Test
  void eventPassesOnlyAfterALongerSilenceThanThePeriod() {
    EventPacket packet = new EventPacket(0);
    packet.append(0, 3, 3, true);
    packet.append(1000, 3, 3, false);
    packet.append(1001, 3, 3, true);
    EventPacket result = filtered(packet, 1000, Silence.SINCE_LAST_PASSED);
    assertEquals(2, result.size());
    assertEquals(1001, result.lastTimeUs());
  }

  @Test
  void continuouslyFiringPixelsPassOncePerPeriodOrNever() {
    EventPacket packet = new EventPacket(0);
    for (int i = 0; i < 100; i++) {
      packet.append(i * 100L, 5, 5, true);
    }
    assertEquals(10, filtered(packet, 999, Silence.SINCE_LAST_PASSED).size());
    assertEquals(1, filtered(packet, 999, Silence.SINCE_LAST_SEEN).size());
  }

  @Test
  void filterMatchesTheReference() {
    for (Silence silence : Silence.values()) {
      for (long seed = 0; seed < 20; seed++) {
        EventPacket stream = EventPackets.uniform(SENSOR, seed, 20_000, -500, 30);
        assertEquals(reference(stream, 3000, silence), filtered(stream, 3000, silence));
      }
    }
  }

  private static EventPacket reference(EventPacket stream, long periodUs, Silence silence) {
    Map<String, Long> last = new HashMap<>();
    EventPacket passed = new EventPacket(0);
    for (int i = 0; i < stream.size(); i++) {
      String pixel = stream.x(i) + "," + stream.y(i);
      long timeUs = stream.timeUs(i);
      boolean passes = !last.containsKey(pixel) || timeUs - last.get(pixel) > periodUs;
      if (passes) {
        passed.append(timeUs, stream.x(i), stream.y(i), stream.isOn(i));
      }
      if (passes || silence == Silence.SINCE_LAST_SEEN) {
        last.put(pixel, timeUs);
      }
    }
    return passed;
  }

  private static EventPacket filtered(EventPacket stream, long periodUs, Silence silence) {
    EventPacket packet = EventPackets.copy(stream);
    new Refractory(SENSOR, new RefractorySettings(periodUs, silence)).filter(packet);
    return packet;
  }
}
