package haltere.core.sink.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Ticks at round numbers. */
class TicksTest {
  @Test
  void ticksAreRound() {
    Ticks ticks = Ticks.of(0, 1, 6);
    assertEquals(0.2, ticks.step(), 1e-12);
    assertEquals(
        List.of("0.0", "0.2", "0.4", "0.6", "0.8", "1.0"),
        ticks.values().stream().map(ticks::label).toList());
  }

  @Test
  void largeAndSmallNumbersAreShort() {
    Ticks large = Ticks.of(0, 4e6, 5);
    assertEquals("2e6", large.label(2e6));
    Ticks small = Ticks.of(0, 5e-6, 6);
    assertEquals("2e-6", small.label(2e-6));
  }

  @Test
  void tickCountIsLimited() {
    SplittableRandom random = new SplittableRandom(3);
    for (int i = 0; i < 2000; i++) {
      double from = (random.nextDouble() - 0.5) * Math.pow(10, random.nextInt(-9, 9));
      double to = from + random.nextDouble() * Math.pow(10, random.nextInt(-9, 9)) + 1e-12;
      int most = random.nextInt(1, 12);
      List<Double> values = Ticks.of(from, to, most).values();
      assertTrue(values.size() <= most);
      double slack = 1e-6 * (to - from) + Math.ulp(from) * 4;
      values.forEach(value -> assertTrue(value >= from - slack && value <= to + slack));
    }
  }

  @Test
  void shortAxisHasTwoTicks() {
    SplittableRandom random = new SplittableRandom(4);
    for (int i = 0; i < 2000; i++) {
      double from = (random.nextDouble() - 0.5) * 1000;
      double to = from + Math.pow(10, random.nextDouble(-3, 4));
      int most = random.nextInt(1, 8);
      int ticks = Ticks.atLeastTwo(from, to, most).values().size();
      assertTrue(ticks >= 2 && ticks <= Math.max(5, most), ticks + " from " + from + " to " + to);
    }
    assertTrue(Ticks.atLeastTwo(1, 1, 3).values().isEmpty());
  }

  @Test
  void emptyAndInfiniteRangesHaveNoTicks() {
    assertTrue(Ticks.of(1, 1, 5).values().isEmpty());
    assertTrue(Ticks.of(0, Double.POSITIVE_INFINITY, 5).values().isEmpty());
    assertTrue(Ticks.of(Double.NaN, 1, 5).values().isEmpty());
  }
}
