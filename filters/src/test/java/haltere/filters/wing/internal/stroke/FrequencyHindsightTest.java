package haltere.filters.wing.internal.stroke;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

class FrequencyHindsightTest {
  private static final double DT_S = 1e-3;
  private static final double SECONDS = 1;
  private static final double OMEGA = 2 * Math.PI * 200;

  /** Stated deviation of the filter's frequency, radians a second. */
  private static final double SD = 2;

  /** A flight whose angular frequency changes evenly, and what a filter says of it. */
  private static FrequencyHindsight after(
      double rate, DoubleUnaryOperator saidOmega, boolean calm, double gapS) {
    FrequencyHindsight hindsight = new FrequencyHindsight();
    FrequencyHistory history = new FrequencyHistory();
    StrokeEkf filter = new StrokeEkf(1);
    double[] sd = new double[filter.size];
    sd[StrokeEkf.OMEGA] = SD;
    filter.launch(new double[filter.size], sd);
    for (double t = 0; t < SECONDS; t += DT_S + gapS) {
      filter.set(StrokeEkf.PHASE, OMEGA * t + rate * t * t / 2);
      filter.set(StrokeEkf.OMEGA, saidOmega.applyAsDouble(t));
      history.add(DT_S + gapS, filter);
      hindsight.update(DT_S + gapS, history, calm);
    }
    return hindsight;
  }

  @Test
  void noiseOfTheFrequencyIsEstimated() {
    SplittableRandom random = new SplittableRandom(1);
    FrequencyHindsight hindsight =
        after(0, t -> OMEGA + (random.nextBoolean() ? 1.2 : -1.2), true, 0);
    assertEquals(1.44 / (SD * SD), hindsight.share(null), 0.05);
  }

  @Test
  void lagBehindAChangingFrequencyIsEstimated() {
    FrequencyHindsight hindsight = after(100, t -> OMEGA + 100 * t - 1.5, true, 0);
    assertEquals(2.25 / (SD * SD), hindsight.share(null), 0.03);
  }

  @Test
  void bothWingsContribute() {
    FrequencyHindsight one = after(0, t -> OMEGA + 1, true, 0);
    FrequencyHindsight other = after(0, t -> OMEGA + 2, true, 0);
    assertEquals((one.share(null) + other.share(null)) / 2, one.share(other), 1e-9);
    assertEquals(one.share(other), other.share(one), 1e-9);
  }

  @Test
  void manoeuvresAndGapsAreExcluded() {
    double usual = after(0, t -> OMEGA + 3, false, 0).share(null);
    assertEquals(0.2, usual, 1e-9);
    assertEquals(usual, after(0, t -> OMEGA + 3, true, 0.03).share(null), 1e-9);
  }
}
