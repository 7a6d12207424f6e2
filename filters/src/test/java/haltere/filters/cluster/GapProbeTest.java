package haltere.filters.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

/** A cluster of 30 pixels, old enough, mostly with 50,000 events a second at places of 3 pixels. */
class GapProbeTest {
  private static final long BORN_US = 1_000_000;
  private static final long OLD_US = BORN_US + 100_000;
  private static final int UPKEEP_US = 1000;
  private static final double EXTENT_PX = 3;

  private final SplittableRandom random = new SplittableRandom(1);
  private final Cluster cluster = new Cluster(0);
  private int eventsPerUpkeep;

  /**
   * Where a place is, pixels, at seconds after the probe has begun, and its polarity: 1, -1, or 0
   * for both.
   */
  private record Place(DoubleUnaryOperator x, DoubleUnaryOperator y, int sign) {
    static Place moving(double x, double y, double vx, double vy, int sign) {
      return new Place(s -> x + vx * s, s -> y + vy * s, sign);
    }

    static Place turning(double radius, double angleRad, double radPerS, int sign) {
      return new Place(
          s -> 100 + radius * StrictMath.cos(angleRad + radPerS * s),
          s -> 100 + radius * StrictMath.sin(angleRad + radPerS * s),
          sign);
    }
  }

  GapProbeTest() {
    new ClusterForm(new SensorGeometry(240, 180), ClusterTrackerSettings.defaults()).begin(cluster);
    cluster.bornUs = BORN_US;
    cluster.setRadii(30, 30);
    makeEvents(50);
  }

  private void makeEvents(int perUpkeep) {
    eventsPerUpkeep = perUpkeep;
    cluster.rateHz = 1e6 * perUpkeep / UPKEEP_US;
  }

  /** When the probe finds another thing, in milliseconds, or -1 for never. */
  private int foundAfterMs(int mostMs, Place... places) {
    GapProbe probe = cluster.probe;
    for (int ms = 0; ms < mostMs; ms++) {
      double seconds = ms * 1e-3;
      for (int i = 0; i < eventsPerUpkeep; i++) {
        Place place = places[random.nextInt(places.length)];
        probe.take(
            place.x().applyAsDouble(seconds) + random.nextDouble(-EXTENT_PX, EXTENT_PX),
            place.y().applyAsDouble(seconds) + random.nextDouble(-EXTENT_PX, EXTENT_PX),
            place.sign() == 0 ? 2 * random.nextInt(2) - 1 : place.sign());
      }
      if (probe.findsAnother(cluster, OLD_US + (long) ms * UPKEEP_US)) {
        return ms;
      }
    }
    return -1;
  }

  @Test
  void aPlaceThatGoesAwayFromAllTheRestIsAnotherThing() {
    int ms =
        foundAfterMs(
            500,
            Place.moving(84, 103, 0, 0, 1),
            Place.moving(86, 105, 0, 0, 1),
            Place.moving(88, 107, 0, 0, 1),
            Place.moving(110, 95, 200, 0, -1));
    assertTrue(ms > 0 && ms < 120, "found after " + ms + " ms");
    GapProbe.Part parted = cluster.probe.near.x > 100 ? cluster.probe.near : cluster.probe.far;
    GapProbe.Part rest = cluster.probe.near.x > 100 ? cluster.probe.far : cluster.probe.near;
    double share = cluster.probe.near.x > 100 ? cluster.probe.share : 1 - cluster.probe.share;
    assertEquals(110 + 0.2 * ms, parted.x, 3);
    assertEquals(95, parted.y, 1);
    assertEquals(200, parted.vx, 250, "of two means within some milliseconds");
    assertEquals(86, rest.x, 1.5);
    assertEquals(105, rest.y, 1.5);
    assertEquals(0, rest.vx, 250);
    assertEquals(0.25, share, 0.08);
    assertEquals(EXTENT_PX * EXTENT_PX / 3, parted.xx, 2);
  }

  @Test
  void whereEventsAreFewAQuarterOfPlacesThatMoveAnyhowIsFoundWithin120Milliseconds() {
    makeEvents(6);
    int soon = 0;
    int scenes = 100;
    for (int scene = 0; scene < scenes; scene++) {
      Place[] places = new Place[3];
      for (int i = 0; i < places.length; i++) {
        double angle = 2 * Math.PI * (i + random.nextDouble(0.5)) / places.length;
        places[i] =
            Place.moving(
                100 + 22 * StrictMath.cos(angle),
                100 + 22 * StrictMath.sin(angle),
                random.nextDouble(-150, 150),
                random.nextDouble(-150, 150),
                1);
      }
      cluster.probe.end();
      soon += foundAfterMs(120, places) > 0 ? 1 : 0;
    }
    assertTrue(soon >= 25, soon + " of " + scenes);
  }

  @Test
  void theEdgesOfAThingAreOneThingAsItMovesAndAsItTurns() {
    assertEquals(
        -1,
        foundAfterMs(
            400,
            Place.moving(80, 100, 300, 100, -1),
            Place.moving(100, 120, 300, 100, 1),
            Place.moving(120, 95, 300, 100, 1)));
    assertEquals(
        -1,
        foundAfterMs(
            400,
            Place.turning(20, 0, 10, 1),
            Place.turning(20, 2, 10, 1),
            Place.turning(20, 4, 10, -1)));
  }

  @Test
  void aPlaceAndAllTheRestWithBothPolaritiesEachAreTwoThingsThoughTheyKeepTheirDistance() {
    int ms = foundAfterMs(100, Place.moving(85, 100, 50, 0, 0), Place.moving(115, 90, 50, 0, 0));
    assertTrue(ms > 0 && ms < 40, "found after " + ms + " ms");
  }

  @Test
  void eventsWithoutAGapAreOneThingHoweverTheyMove() {
    Place[] places = new Place[12];
    for (int i = 0; i < places.length; i++) {
      places[i] = Place.moving(75 + 4.5 * i, 100, -150 + 30 * i, 0, 0);
    }
    assertEquals(-1, foundAfterMs(50, places));
  }

  @Test
  void aYoungClusterAndASmallOneAreNotProbed() {
    Place[] places = {Place.moving(80, 100, 0, 0, 0), Place.moving(110, 95, 200, 0, 0)};
    cluster.bornUs = OLD_US;
    assertEquals(-1, foundAfterMs(70, places));
    cluster.bornUs = BORN_US;
    cluster.setRadii(5, 5);
    assertEquals(-1, foundAfterMs(70, places));
    assertFalse(cluster.probe.findsAnother(cluster, OLD_US));
  }
}
