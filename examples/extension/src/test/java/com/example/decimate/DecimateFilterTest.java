package com.example.decimate;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.chain.EventFilter;
import haltere.core.chain.Filters;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.testing.EventFilterContract;
import org.junit.jupiter.api.Test;

class DecimateFilterTest extends EventFilterContract {
  @Override
  protected EventFilter create(SensorGeometry geometry) {
    return new DecimateFilter(geometry, DecimateSettings.defaults());
  }

  @Test
  void filterIsFoundByItsName() {
    assertEquals("Passes every n-th event.", Filters.named("decimate").description());
  }

  @Test
  void everySecondEventPasses() {
    EventPacket packet = new EventPacket(5);
    for (int i = 0; i < 5; i++) {
      packet.append(i, i, 0, true);
    }
    create(new SensorGeometry(8, 8)).process(packet);
    assertEquals(2, packet.size());
    assertEquals(1, packet.timeUs(0));
    assertEquals(3, packet.timeUs(1));
  }
}
