package haltere.ui.viewer.playback;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** Heights in the time bar. */
class RateScaleTest {
  @Test
  void burstDoesNotFlattenOtherRates() {
    double[] rates = new double[100];
    Arrays.fill(rates, 50_000);
    rates[40] = 9_000_000;
    double[] heights = RateScale.heights(rates, false);
    assertEquals(1, heights[10]);
    assertTrue(heights[40] > 1, "the burst is clipped");
  }

  @Test
  void similarRatesAreShownInProportion() {
    assertArrayEquals(
        new double[] {0.25, 0.5, 1, 0}, RateScale.heights(new double[] {1, 2, 4, 0}, false), 1.01);
    double[] heights = RateScale.heights(new double[] {100, 200, 200, 200}, false);
    assertArrayEquals(new double[] {0.5, 1, 1, 1}, heights);
  }

  @Test
  void decadesHaveEqualHeightsOnTheLogarithmicScale() {
    double[] heights = RateScale.heights(new double[] {0, 1, 10, 100, 1000}, true);
    assertArrayEquals(new double[] {0, 0.25, 0.5, 0.75, 1}, heights, 1e-9);
  }

  @Test
  void burstLeavesHeightForOtherRatesOnTheLogarithmicScale() {
    double[] rates = new double[100];
    Arrays.fill(rates, 50_000);
    rates[40] = 9_000_000;
    double[] heights = RateScale.heights(rates, true);
    assertTrue(heights[10] > 0.25, "height " + heights[10]);
    assertEquals(1, heights[40], 1e-9);
  }

  @Test
  void similarRatesHaveSimilarHeightsOnTheLogarithmicScale() {
    double[] heights = RateScale.heights(new double[] {90, 100}, true);
    double lower = 1 + Math.log10(0.9) / (1 - Math.log10(0.9));
    assertArrayEquals(new double[] {lower, 1}, heights, 1e-9);
  }

  @Test
  void heightsAreZeroWithoutEvents() {
    assertArrayEquals(new double[3], RateScale.heights(new double[3], false));
  }
}
