package haltere.filters.track.kalman;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.filters.track.RoadMapping;
import haltere.filters.track.RoadSettings;
import haltere.filters.track.VanishingPoint;
import haltere.filters.track.road.RoadEvents;
import java.util.Random;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

/** A motorcycle that comes at 12 m/s and is found 24 m away, and a line at 36 m. */
class SeenWayTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private static final RoadSettings VIEW =
      new RoadSettings(5, 6, 300, VanishingPoint.at(63.5, 127));
  private static final double LINE_M = 36;
  private static final double SPEED_M_S = -12;
  private static final double FOUND_M = 24;
  private static final double X_M = -1.75;
  private static final long NOW_US = 3_000_000;

  private final RoadMapping road = new RoadMapping(VIEW, SENSOR);
  private final RoadEvents events = new RoadEvents(road, SENSOR);
  private final SeenWay way = new SeenWay(road, events);
  private final TreeMap<Long, int[]> pixels = new TreeMap<>();

  private Track track(double halfM) {
    Track track = GivenTrack.in(new MeasurementPlane(road));
    track.serial = 7;
    track.bornUs = NOW_US;
    track.stateUs = NOW_US;
    track.line.halfWidthM = halfM;
    track.motion.launch(X_M, FOUND_M - SPEED_M_S, 1e-4, 0, 1e-4);
    track.motion.coast(1, 1);
    track.motion.innovate(X_M, FOUND_M, 1e-6, 0, 1e-6);
    track.motion.correct();
    return track;
  }

  private void add(double timeUs, int column, int row) {
    long at = Math.round(timeUs);
    while (pixels.containsKey(at)) {
      at++;
    }
    pixels.put(at, new int[] {column, row});
  }

  /** Two events of each row that the motorcycle passes, when it passes it. */
  private void drive() {
    for (int row = (int) road.rowOf(FOUND_M) + 1; road.distanceM(row) < LINE_M + 2; row++) {
      double ageS = (road.distanceM(row) - FOUND_M) / SPEED_M_S;
      int column = (int) Math.round(road.columnOf(X_M, road.distanceM(row)));
      add(NOW_US + ageS * 1e6, column, row);
      add(NOW_US + ageS * 1e6 + 300, column + 1, row);
    }
  }

  /** Events of single pixels anywhere. */
  private void rain(int count) {
    Random random = new Random(5);
    for (int k = 0; k < count; k++) {
      add(NOW_US - 1 - random.nextInt(2_000_000), random.nextInt(128), random.nextInt(120));
    }
  }

  private boolean leads(Track track) {
    EventPacket packet = new EventPacket(Math.max(1, pixels.size()));
    pixels.forEach((at, pixel) -> packet.append(at, pixel[0], pixel[1], true));
    events.add(packet);
    events.step(NOW_US);
    return way.leadsTo(track, track.motion, LINE_M, NOW_US);
  }

  @Test
  void theEventsOfTheMotorcycleLeadBackToTheLine() {
    drive();
    assertTrue(leads(track(0.3)));
  }

  @Test
  void inTheRainTheyDoToo() {
    drive();
    rain(2000);
    assertTrue(leads(track(0.3)));
  }

  @Test
  void emptyRoadDoesNotAndRainDoesNot() {
    assertFalse(leads(track(0.3)));
    rain(20_000);
    assertFalse(leads(track(0.3)));
  }

  @Test
  void theWayOfAnotherVehicleIsNotItsOwn() {
    drive();
    EventPacket none = new EventPacket(1);
    events.add(none);
    assertTrue(leads(track(0.3)));
    for (long i = 0; i < events.to(); i++) {
      events.take(i, 3);
    }
    Track track = track(0.3);
    assertFalse(way.leadsTo(track, track.motion, LINE_M, NOW_US));
    for (long i = 0; i < events.to(); i++) {
      events.take(i, track.serial);
    }
    assertTrue(way.leadsTo(track, track.motion, LINE_M, NOW_US));
  }

  @Test
  void whatIsSoLargeWouldHaveBeenFoundBefore() {
    drive();
    assertFalse(leads(track(1.25)));
  }
}
