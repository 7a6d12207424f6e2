package haltere.filters.object;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ActivityGridTest {
  private final ActivityGrid grid = new ActivityGrid(new SensorGeometry(10, 7));

  @Test
  void pixelCountsOncePerTick() {
    grid.add(9, 6, 100);
    grid.add(9, 6, 900);
    grid.add(8, 6, 300);
    int tile = grid.nextTile(0);
    assertEquals(-1, grid.nextTile(tile + 1));
    assertEquals(8, grid.x(tile));
    assertEquals(4, grid.y(tile));
    assertEquals(1 << 2 * 4 | 1 << 2 * 4 + 1, grid.pixels(tile));
    assertEquals(200e-6, grid.meanS(tile), 1e-12);
  }

  @Test
  void nextTickStartsEmpty() {
    grid.add(3, 3, 0);
    grid.next();
    assertEquals(-1, grid.nextTile(0));
    grid.add(3, 3, 5000);
    assertEquals(5000e-6, grid.meanS(grid.nextTile(0)), 1e-12);
  }

  @Test
  void meanTimeOfAFullTileDoesNotOverflow() {
    for (int i = 0; i < 16; i++) {
      grid.add(4 + i % 4, i / 4, 9999);
    }
    assertEquals(0xffff, grid.pixels(grid.nextTile(0)));
    assertEquals(9999e-6, grid.meanS(grid.nextTile(0)), 1e-12);
  }

  @ParameterizedTest
  @CsvSource({"1, 1", "16, 16", "17, 33", "128, 128", "1280, 720"})
  void everyActiveTileIsVisitedOnceAtItsPosition(int width, int height) {
    ActivityGrid picture = new ActivityGrid(new SensorGeometry(width, height));
    Set<Integer> expected = new HashSet<>();
    for (int y = 0; y < height; y += 4) {
      for (int x = 0; x < width; x += 4) {
        picture.add(x, y, 0);
        expected.add(y * width + x);
      }
    }
    for (int tile = picture.nextTile(0); tile >= 0; tile = picture.nextTile(tile + 1)) {
      assertTrue(expected.remove(picture.y(tile) * width + picture.x(tile)));
    }
    assertEquals(Set.of(), expected);
  }
}
