package haltere.core.format.summary;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Bins over any span of time. */
class TimeBinsTest {
  @ParameterizedTest
  @ValueSource(longs = {1L << 40, 1L << 62, Long.MAX_VALUE, Long.MIN_VALUE, -5})
  void everySampleIsCountedWhateverItsTime(long elapsedUs) {
    TimeBins bins = new TimeBins(48, 10_000);
    bins.add(0, 1);
    bins.add(elapsedUs, 1);
    assertEquals(1, bins.count(0));
    assertEquals(1, bins.count(bins.size() - 1));
  }
}
