package haltere.ui.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Curves of bounded memory, held against all samples there were. */
class CurveTest {
  private record Stretch(long fromUs, long toUs, double lowest, double highest, boolean joined) {}

  private static List<Stretch> paint(Curve curve, long fromUs, long toUs, int columns) {
    List<Stretch> stretches = new ArrayList<>();
    curve.paint(
        fromUs,
        toUs,
        columns,
        (from, to, low, high, joined) -> stretches.add(new Stretch(from, to, low, high, joined)));
    return stretches;
  }

  @Test
  void fewSamplesArePaintedUnchanged() {
    Curve curve = new Curve("a", 0);
    for (int i = 0; i < 10; i++) {
      curve.add(i * 1000L, i);
    }
    List<Stretch> stretches = paint(curve, 2000, 5000, 100);
    // one on either side leads to the edges
    assertEquals(new Stretch(1000, 1000, 1, 1, false), stretches.get(0));
    assertEquals(new Stretch(6000, 6000, 6, 6, true), stretches.get(stretches.size() - 1));
    assertEquals(6, stretches.size());
  }

  @Test
  void everyWindowShowsTheExtremesOfItsSamples() {
    SplittableRandom random = new SplittableRandom(7);
    int samples = 300_000;
    double[] values = new double[samples];
    Curve curve = new Curve("a", 0);
    for (int i = 0; i < samples; i++) {
      values[i] = random.nextDouble() + 3 * Math.sin(i / 20_000.0);
      curve.add(i * 1000L, values[i]);
    }
    for (int trial = 0; trial < 200; trial++) {
      int from = random.nextInt(samples);
      int to = from + random.nextInt(samples - from);
      double lowest = Double.POSITIVE_INFINITY;
      double highest = Double.NEGATIVE_INFINITY;
      for (int i = from; i <= to; i++) {
        lowest = Math.min(lowest, values[i]);
        highest = Math.max(highest, values[i]);
      }
      double shownLowest = Double.POSITIVE_INFINITY;
      double shownHighest = Double.NEGATIVE_INFINITY;
      long before = Long.MIN_VALUE;
      for (Stretch stretch : paint(curve, from * 1000L, to * 1000L, 500)) {
        shownLowest = Math.min(shownLowest, stretch.lowest());
        shownHighest = Math.max(shownHighest, stretch.highest());
        assertTrue(stretch.fromUs() > before, "stretches overlap or go back");
        before = stretch.toUs();
      }
      assertTrue(shownLowest <= lowest && shownHighest >= highest, "samples are not shown");
    }
  }

  @Test
  void hoursOfSamplesFitIntoFourMegabytes() {
    Curve curve = new Curve("a", 0);
    int samples = 36_000_000;
    for (int i = 0; i < samples; i++) {
      curve.add(i * 1000L, i % 1000);
    }
    assertTrue(curve.bytes() <= 4 << 20, curve.bytes() + " bytes");
    List<Stretch> all = paint(curve, 0, samples * 1000L, 800);
    assertTrue(all.get(0).fromUs() <= 5_000_000, "starts at " + all.get(0).fromUs());
    assertEquals((samples - 1) * 1000L, all.get(all.size() - 1).toUs());
    assertTrue(all.size() < 80_000, all.size() + " stretches");
  }

  @Test
  void silenceIsAGapAndASlowRateIsNot() {
    Curve curve = new Curve("a", 0);
    curve.add(0, 1);
    curve.add(1000, 1);
    curve.add(10_000_000, 1);
    List<Stretch> stretches = paint(curve, 0, 20_000_000, 100);
    assertTrue(stretches.get(1).joined());
    assertFalse(stretches.get(2).joined(), "ten seconds of silence after a millisecond");
    Curve slow = new Curve("b", 0);
    for (int i = 0; i < 5; i++) {
      slow.add(i * 1_000_000L, i);
    }
    assertTrue(paint(slow, 0, 5_000_000, 100).get(4).joined(), "once a second is no silence");
  }

  @Test
  void decreasingTimeRestartsTheCurve() {
    Curve curve = new Curve("a", 0);
    curve.add(5000, 1);
    curve.add(1000, 2);
    assertEquals(1, paint(curve, 0, 10_000, 100).size());
    assertEquals(2, curve.last());
  }

  @Test
  void truncatingACurveLeavesTheStateOfItsEarlierSamples() {
    SplittableRandom random = new SplittableRandom(11);
    for (int trial = 0; trial < 20; trial++) {
      Curve curve = new Curve("a", 0);
      Curve expected = new Curve("a", 0);
      int cut = 1 + random.nextInt(40_000);
      int beyond = cut + random.nextInt(20_000);
      for (int i = 0; i < beyond; i++) {
        curve.add(i * 1000L, i < cut ? i : -1);
      }
      for (int i = 0; i < cut; i++) {
        expected.add(i * 1000L, i);
      }
      for (int i = cut; i < cut + 5000; i++) {
        curve.add(i * 1000L, 2 * i);
        expected.add(i * 1000L, 2 * i);
      }
      assertEquals(expected.lastUs(), curve.lastUs());
      for (int columns : new int[] {1, 10, 500}) {
        assertEquals(
            paint(expected, 0, 100_000_000, columns), paint(curve, 0, 100_000_000, columns));
      }
    }
  }

  @Test
  void nonFiniteValuesAreSkipped() {
    Curve curve = new Curve("a", 0);
    curve.add(1000, Double.NaN);
    curve.add(2000, Double.POSITIVE_INFINITY);
    assertEquals(Long.MIN_VALUE, curve.lastUs());
    assertTrue(Double.isNaN(curve.valueAt(1000)));
  }

  @Test
  void valueAtATimeIsThatOfTheNearestSample() {
    Curve curve = new Curve("a", 0);
    for (int i = 0; i < 100; i++) {
      curve.add(i * 1000L, i);
    }
    assertEquals(42, curve.valueAt(42_400));
    assertEquals(43, curve.valueAt(42_600));
    assertTrue(Double.isNaN(curve.valueAt(50_000_000)), "nothing is near");
  }
}
