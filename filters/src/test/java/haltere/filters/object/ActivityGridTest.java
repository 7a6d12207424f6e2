package haltere.filters.object;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.event.SensorGeometry;
import org.junit.jupiter.api.Test;

class ActivityGridTest {
  private final ActivityGrid grid = new ActivityGrid(new SensorGeometry(10, 7));

  @Test
  void aPixelCountsOnceInATick() {
    grid.add(9, 6, 100);
    grid.add(9, 6, 900);
    grid.add(8, 6, 300);
    assertEquals(1, grid.count());
    int tile = grid.tile(0);
    assertEquals(8, grid.x(tile));
    assertEquals(4, grid.y(tile));
    assertEquals(1 << 2 * 4 | 1 << 2 * 4 + 1, grid.pixels(tile));
    assertEquals(200e-6, grid.meanS(tile), 1e-12);
  }

  @Test
  void theNextTickBeginsEmptyAndCountsAllAgain() {
    grid.add(3, 3, 0);
    grid.next();
    assertEquals(0, grid.count());
    grid.add(3, 3, 5000);
    assertEquals(1, grid.count());
    assertEquals(5000e-6, grid.meanS(grid.tile(0)), 1e-12);
  }

  @Test
  void timesOfAFullTileAtTheEndOfATickAddUp() {
    for (int i = 0; i < 16; i++) {
      grid.add(4 + i % 4, i / 4, 9999);
    }
    assertEquals(0xffff, grid.pixels(grid.tile(0)));
    assertEquals(9999e-6, grid.meanS(grid.tile(0)), 1e-12);
  }
}
