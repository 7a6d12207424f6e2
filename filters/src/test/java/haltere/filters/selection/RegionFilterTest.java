package haltere.filters.selection;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.chain.EventFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.filters.selection.RegionSettings.RegionSide;
import haltere.testing.EventFilterContract;
import org.junit.jupiter.api.Test;

class RegionFilterTest extends EventFilterContract {
  @Override
  protected EventFilter create(SensorGeometry geometry) {
    return new RegionFilter(new RegionSettings(10, 20, 50, 30, RegionSide.INSIDE));
  }

  @Test
  void rectangleIncludesItsFirstAndLastRowAndColumn() {
    RegionSettings inside = new RegionSettings(2, 3, 4, 2, RegionSide.INSIDE);
    RegionSettings outside = new RegionSettings(2, 3, 4, 2, RegionSide.OUTSIDE);
    for (int x = 0; x < 10; x++) {
      for (int y = 0; y < 10; y++) {
        boolean in = x >= 2 && x <= 5 && y >= 3 && y <= 4;
        assertEquals(in ? 1 : 0, eventsLeft(inside, x, y), "inside, pixel " + x + ", " + y);
        assertEquals(in ? 0 : 1, eventsLeft(outside, x, y), "outside, pixel " + x + ", " + y);
      }
    }
  }

  @Test
  void defaultsPassAllPixelsAndAnEmptyRectangleNone() {
    assertEquals(1, eventsLeft(RegionSettings.defaults(), 0, 0));
    assertEquals(1, eventsLeft(RegionSettings.defaults(), 32_767, 32_767));
    assertEquals(0, eventsLeft(new RegionSettings(5, 5, 0, 9, RegionSide.INSIDE), 5, 5));
    assertEquals(1, eventsLeft(new RegionSettings(5, 5, 0, 9, RegionSide.OUTSIDE), 5, 5));
  }

  private static int eventsLeft(RegionSettings settings, int x, int y) {
    EventPacket packet = new EventPacket(1);
    packet.append(0, x, y, true);
    new Region(settings).filter(packet);
    return packet.size();
  }
}
