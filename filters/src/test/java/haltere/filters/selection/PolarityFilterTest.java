package haltere.filters.selection;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.EventFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.filters.selection.PolaritySettings.Keep;
import haltere.testing.EventFilterContract;
import haltere.testing.EventPackets;
import org.junit.jupiter.api.Test;

class PolarityFilterTest extends EventFilterContract {
  @Override
  protected EventFilter create(SensorGeometry geometry) {
    return new PolarityFilter(new PolaritySettings(Keep.ON));
  }

  @Test
  void exactlyTheEventsOfTheSelectedPolarityPass() {
    EventPacket stream = EventPackets.uniform(new SensorGeometry(8, 8), 1, 1000, 0, 10);
    EventPacket on = selected(stream, Keep.ON);
    EventPacket off = selected(stream, Keep.OFF);
    for (int i = 0; i < on.size(); i++) {
      assertTrue(on.isOn(i));
    }
    for (int i = 0; i < off.size(); i++) {
      assertFalse(off.isOn(i));
    }
    assertEquals(stream.size(), on.size() + off.size());
    assertEquals(stream, selected(stream, Keep.BOTH));
  }

  private static EventPacket selected(EventPacket stream, Keep keep) {
    EventPacket packet = EventPackets.copy(stream);
    new PolaritySelection(new PolaritySettings(keep)).filter(packet);
    return packet;
  }
}
