package haltere.filters.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.filters.estimation.Consistency;
import haltere.filters.estimation.Interval;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.LongToDoubleFunction;
import org.junit.jupiter.api.Test;

class ClusterContourTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private static final double RADIUS = 6;
  private static final long STEP_US = 200;

  private final LongToDoubleFunction x = timeUs -> 10 + 100e-6 * timeUs;
  private final LongToDoubleFunction entering = timeUs -> -9 + 100e-6 * timeUs;
  private double outlineSquares;
  private double meanSquares;
  private double normalised;
  private double misfits;
  private int readings;
  private int outlines;

  /** Reads what a tracker finds out about a thing that goes to the right, for half a second. */
  private void read(EventPacket events, LongToDoubleFunction trueX, long fromUs, long toUs) {
    ClusterTracker tracker =
        new ClusterTracker(SENSOR, ClusterTrackerSettings.defaults(), timeUs -> {});
    tracker.observe(
        (timeUs, at) -> {
          if (at.count() != 1 || !(at.newEvents(0) > 0) || timeUs < fromUs || timeUs > toUs) {
            return;
          }
          readings++;
          double truth = trueX.applyAsDouble(timeUs - Math.round(at.measuredAgeUs(0)));
          meanSquares += Math.pow(at.measuredX(0) - truth, 2);
          double a = at.outlineXx(0);
          double b = at.outlineXy(0);
          double c = at.outlineYy(0);
          double determinant = a * c - b * b;
          if (determinant > 0) {
            outlines++;
            misfits += at.outlineMisfitVariance(0);
            double dx = (c * at.outlineX(0) - b * at.outlineY(0)) / determinant - truth;
            double dy = (a * at.outlineY(0) - b * at.outlineX(0)) / determinant - 60;
            outlineSquares += dx * dx;
            normalised += a * dx * dx + 2 * b * dx * dy + c * dy * dy;
          }
        },
        10_000);
    tracker.track(events);
  }

  /** OFF events at the edge in front of a disc, ON events at the one behind. */
  private static EventPacket disc(long seed, LongToDoubleFunction x) {
    return disc(seed, x, 60);
  }

  private static EventPacket disc(long seed, LongToDoubleFunction x, double y) {
    SplittableRandom random = new SplittableRandom(seed);
    EventPacket events = new EventPacket(8192);
    for (long timeUs = 0; timeUs < 600_000; timeUs += STEP_US) {
      double across = random.nextDouble(-RADIUS, RADIUS);
      boolean on = random.nextBoolean();
      double ahead = Math.sqrt(RADIUS * RADIUS - across * across);
      add(events, timeUs, x.applyAsDouble(timeUs) + (on ? -ahead : ahead), y + across, on);
    }
    return events;
  }

  private static void add(EventPacket events, long timeUs, double atX, double atY, boolean on) {
    int column = (int) Math.floor(atX + 0.5);
    int row = (int) Math.floor(atY + 0.5);
    if (SENSOR.contains(column, row)) {
      events.append(timeUs, column, row, on);
    }
  }

  @Test
  void theMiddleOfAnOutlineIsKnownBetterThanTheMeanOfItsEvents() {
    for (long seed = 0; seed < 20; seed++) {
      read(disc(seed, x), x, 100_000, 600_000);
    }
    assertEquals(readings, outlines);
    double outlineRms = Math.sqrt(outlineSquares / readings);
    double meanRms = Math.sqrt(meanSquares / readings);
    assertTrue(outlineRms < 0.12, "RMS " + outlineRms);
    assertTrue(meanRms > 1.5 * outlineRms, "mean " + meanRms + ", outline " + outlineRms);
    // Two degrees of freedom; pixels are no Gaussian noise.
    assertTrue(normalised / readings > 0.8 && normalised / readings < 2.6, normalised + "");
  }

  @Test
  void whatIsHalfInThePictureIsWhereItIsAndNotWhereItIsSeen() {
    for (long seed = 0; seed < 20; seed++) {
      // Its middle is in the picture from 90 ms on, its rear edge from 150 ms on.
      read(disc(seed, entering), entering, 110_000, 150_000);
    }
    assertTrue(outlines > 0.8 * readings, outlines + " of " + readings);
    double outlineRms = Math.sqrt(outlineSquares / outlines);
    assertTrue(outlineRms < 0.2, "RMS " + outlineRms);
    Interval band = Consistency.meanBand(2, outlines, 0.95);
    double honesty = normalised / outlines;
    assertTrue(band.lower() < honesty && honesty < band.upper(), honesty + " in " + band);
    assertTrue(Math.sqrt(meanSquares / readings) > 1.5 * outlineRms, "mean " + meanSquares);
  }

  @Test
  void twoDiscsThatAreTakenForOneAreKnownNoBetterThanTheyAreApart() {
    LongToDoubleFunction between = timeUs -> x.applyAsDouble(timeUs) + 1.5;
    for (long seed = 0; seed < 10; seed++) {
      EventPacket first = disc(seed, x);
      EventPacket second = disc(seed + 100, timeUs -> x.applyAsDouble(timeUs) + 3);
      EventPacket both = new EventPacket(first.size() + second.size());
      for (int i = 0; i < first.size(); i++) {
        both.append(first, i, i + 1);
        both.append(second, i, i + 1);
      }
      read(both, between, 200_000, 600_000);
    }
    assertTrue(outlines > 0.8 * readings, outlines + " of " + readings);
    // Either disc is 1.5 px from the middle of both.
    double misfit = Math.sqrt(misfits / outlines);
    assertTrue(misfit > 1 && misfit < 3, "standard deviation " + misfit);
  }

  @Test
  void oneDiscIsKnownAsWellAsItsOutline() {
    for (long seed = 0; seed < 10; seed++) {
      read(disc(seed, x), x, 100_000, 600_000);
    }
    assertEquals(0, misfits / outlines, 1e-3);
  }

  @Test
  void theMeanOfWhatTheBorderCutsOffAPartOfIsAsUnsureAsItIsOff() {
    for (int row = 0; row < 6; row++) {
      int middle = row;
      double[] sums = new double[2];
      for (long seed = 0; seed < 5; seed++) {
        ClusterTracker tracker =
            new ClusterTracker(SENSOR, ClusterTrackerSettings.defaults(), timeUs -> {});
        tracker.observe(
            (timeUs, at) -> {
              if (timeUs > 200_000 && at.count() == 1 && at.newEvents(0) > 0) {
                sums[0] += at.unseenVariance(0);
                sums[1] += Math.pow(at.measuredY(0) - middle, 2);
              }
            },
            10_000);
        tracker.track(disc(seed, x, middle));
      }
      double ratio = sums[0] / sums[1];
      assertTrue(ratio > 0.4 && ratio < 3, "at row " + row + " stated over true " + ratio);
    }
  }

  @Test
  void whatIsFilledHasNoOutline() {
    SplittableRandom random = new SplittableRandom(3);
    EventPacket events = new EventPacket(8192);
    for (long timeUs = 0; timeUs < 600_000; timeUs += STEP_US) {
      double distance = RADIUS * Math.sqrt(random.nextDouble());
      double angle = random.nextDouble(2 * Math.PI);
      double atX = x.applyAsDouble(timeUs) + distance * Math.cos(angle);
      add(events, timeUs, atX, 60 + distance * Math.sin(angle), random.nextBoolean());
    }
    read(events, x, 100_000, 600_000);
    assertTrue(readings > 40, "readings " + readings);
    assertEquals(0, outlines);
  }

  @Test
  void aStraightLineHasNoOutlineThoughItFitsAPartOfALargeRing() {
    SplittableRandom random = new SplittableRandom(4);
    EventPacket events = new EventPacket(8192);
    for (long timeUs = 0; timeUs < 600_000; timeUs += STEP_US) {
      double along = 60 + random.nextDouble(-12, 12);
      add(events, timeUs, x.applyAsDouble(timeUs) + 0.3 * random.nextGaussian(), along, true);
    }
    read(events, x, 100_000, 600_000);
    assertTrue(readings > 40, "readings " + readings);
    assertEquals(0, outlines);
    assertTrue(Math.sqrt(meanSquares / readings) < 0.5, "mean " + meanSquares);
  }

  @Test
  void ofASmallThingInNoiseThereIsHardlyEverALargeRingBesideIt() {
    int found = 0;
    int beside = 0;
    for (long seed = 0; seed < 30; seed++) {
      for (double[] off : outlinesOfASmallThing(seed)) {
        found++;
        beside += Math.hypot(off[0], off[1]) > 6 ? 1 : 0;
      }
    }
    assertTrue(found > 150, "outlines " + found);
    assertTrue(beside < 0.03 * found, beside + " of " + found);
  }

  /** How far sure outlines are off, of a disc of 3 px in as many events of noise as its own. */
  private static List<double[]> outlinesOfASmallThing(long seed) {
    SensorGeometry sensor = new SensorGeometry(240, 240);
    LongToDoubleFunction way = timeUs -> 60 + 40e-6 * timeUs;
    SplittableRandom random = new SplittableRandom(seed);
    EventPacket events = new EventPacket(65_536);
    double ownHz = 400;
    double hz = ownHz + 0.3 * sensor.pixels();
    for (double s = 0; s < 1.5; s -= Math.log(1 - random.nextDouble()) / hz) {
      long timeUs = (long) (s * 1e6);
      boolean on = random.nextBoolean();
      if (random.nextDouble() * hz < ownHz) {
        double across = random.nextDouble(-3, 3);
        double ahead = Math.sqrt(9 - across * across);
        double atX = way.applyAsDouble(timeUs) + (on ? -ahead : ahead);
        add(events, timeUs, atX, 60 + across, on);
      } else {
        events.append(timeUs, random.nextInt(240), random.nextInt(240), on);
      }
    }
    ClusterTracker tracker =
        new ClusterTracker(sensor, ClusterTrackerSettings.defaults(), timeUs -> {});
    List<double[]> offs = new ArrayList<>();
    tracker.observe(
        (timeUs, at) -> {
          for (int i = 0; i < at.count(); i++) {
            double a = at.outlineXx(i);
            double b = at.outlineXy(i);
            double c = at.outlineYy(i);
            double determinant = a * c - b * b;
            if (a + c < 2 * determinant) {
              double truth = way.applyAsDouble(timeUs - Math.round(at.measuredAgeUs(i)));
              offs.add(
                  new double[] {
                    (c * at.outlineX(i) - b * at.outlineY(i)) / determinant - truth,
                    (a * at.outlineY(i) - b * at.outlineX(i)) / determinant - 60
                  });
            }
          }
        },
        20_000);
    tracker.track(events);
    return offs;
  }
}
