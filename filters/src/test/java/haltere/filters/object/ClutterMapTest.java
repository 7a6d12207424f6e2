package haltere.filters.object;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class ClutterMapTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(64, 64);

  private final ActivityGrid grid = new ActivityGrid(SENSOR);
  private final ClutterMap clutter = new ClutterMap(SENSOR, grid);
  private final SplittableRandom random = new SplittableRandom(1);

  /** A tick in which each pixel fires with its probability. */
  private void tick(double usual, int hotTile, double hot) {
    clutter.begin(1);
    for (int tile = 0; tile < grid.tiles(); tile++) {
      for (int pixel = 0; pixel < ActivityGrid.TILE_PIXELS; pixel++) {
        if (random.nextDouble() < (tile == hotTile && pixel == 0 ? hot : usual)) {
          clutter.add(tile, pixel, clutter.cellAt(grid.x(tile), grid.y(tile)), 1);
        }
      }
    }
    clutter.end();
  }

  @Test
  void hotPixelHasItsOwnRateAndOthersShareACellRate() {
    for (int i = 0; i < 1000; i++) {
      tick(0.01, 5, 0.5);
    }
    clutter.begin(1);
    assertEquals(0.5, clutter.rate(5, 0), 0.1);
    double sum = 0;
    for (int pixel = 1; pixel < ActivityGrid.TILE_PIXELS; pixel++) {
      sum += clutter.rate(100, pixel) / (ActivityGrid.TILE_PIXELS - 1);
    }
    assertEquals(0.01, sum, 0.004);
  }

  @Test
  void pixelThatFiresInMostTicksFlickersWhateverExplainsIt() {
    int lamp = 0;
    int edge = 9;
    for (int i = 0; i < 100; i++) {
      clutter.begin(1);
      if (i < 30 || i > 60) {
        assertEquals(i > 60, clutter.isFlickering(lamp, 0), "after " + i + " ticks");
      }
      clutter.add(lamp, 0, clutter.cellAt(grid.x(lamp), grid.y(lamp)), 0);
      if (i % 3 == 0) {
        clutter.add(edge, 0, clutter.cellAt(grid.x(edge), grid.y(edge)), 0);
      }
      assertFalse(clutter.isFlickering(edge, 0), "edges that pass repeatedly");
      clutter.end();
    }
  }

  @Test
  void burstInOneCellIsExcessAndUsualNoiseIsNot() {
    for (int i = 0; i < 500; i++) {
      tick(0.01, -1, 0);
    }
    int excessive = 0;
    for (int cell = 0; cell < clutter.cells; cell++) {
      excessive += clutter.logRatio(cell) > 6 ? 1 : 0;
      assertEquals(clutter.logRatio(cell) >= 2, clutter.isExcess(cell, 2));
    }
    assertTrue(excessive <= 1, excessive + " cells");
    for (int i = 0; i < 30; i++) {
      clutter.add(0, i % 16, 0, 1);
    }
    assertTrue(clutter.logRatio(0) > 12, clutter.logRatio(0) + " nat");
  }

  @Test
  void flashOverThePictureRaisesAllRates() {
    for (int i = 0; i < 500; i++) {
      tick(0.01, -1, 0);
    }
    double before = clutter.rate(7, 3);
    for (int i = 0; i < 5; i++) {
      tick(0.2, -1, 0);
    }
    clutter.begin(1);
    assertTrue(clutter.rate(7, 3) > 5 * before);
    for (int cell = 0; cell < clutter.cells; cell++) {
      assertTrue(clutter.logRatio(cell) < 12, clutter.logRatio(cell) + " nat");
    }
  }

  @Test
  void silenceLowersTheRates() {
    for (int i = 0; i < 500; i++) {
      tick(0.05, -1, 0);
    }
    double before = clutter.rate(7, 3);
    clutter.begin(2000);
    clutter.end();
    clutter.begin(1);
    assertTrue(clutter.rate(7, 3) < 0.2 * before);
  }
}
