package haltere.filters.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import java.util.HashMap;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

class ClusterLinesTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);

  private final Map<Integer, Double> firstY = new HashMap<>();
  private double greatestWay;
  private double speeds;
  private int onLines;
  private int readings;

  /** Reads a tracker from 0.25 s on. */
  private void read(EventPacket events) {
    ClusterTracker tracker =
        new ClusterTracker(SENSOR, ClusterTrackerSettings.defaults(), timeUs -> {});
    tracker.observe(
        (timeUs, at) -> {
          for (int i = 0; i < at.count(); i++) {
            if (timeUs < 250_000 || !(at.newEvents(i) > 0)) {
              continue;
            }
            readings++;
            speeds += at.vy(i);
            if (at.lineX(i) != 0 || at.lineY(i) != 0) {
              onLines++;
              assertEquals(1, Math.abs(at.lineY(i)), 0.02);
              assertEquals(0, at.vy(i), 10, "along the line");
            }
            firstY.putIfAbsent(at.id(i), at.measuredY(i));
            greatestWay = Math.max(greatestWay, Math.abs(at.measuredY(i) - firstY.get(at.id(i))));
          }
        },
        10_000);
    tracker.track(events);
  }

  /** Events on an upright line that goes to the right; where on it is up to the caller. */
  private static EventPacket line(DoubleUnaryOperator yOfShare, double vx, double vy) {
    SplittableRandom random = new SplittableRandom(7);
    EventPacket events = new EventPacket(16_384);
    for (long timeUs = 0; timeUs < 700_000; timeUs += 100) {
      double seconds = timeUs * 1e-6;
      int column = (int) Math.floor(30.5 + vx * seconds);
      int row = (int) Math.floor(0.5 + yOfShare.applyAsDouble(random.nextDouble()) + vy * seconds);
      if (SENSOR.contains(column, row)) {
        events.append(timeUs, column, row, random.nextBoolean());
      }
    }
    return events;
  }

  @Test
  void onALineThatGoesOnClustersMoveAcrossItOnlyThoughThereAreMoreEventsAtOneEnd() {
    // Free to slide they do so at 80 px/s in the mean, by up to 59 px.
    read(line(share -> 127 * Math.sqrt(share), 60, 0));
    assertTrue(onLines > 0.4 * readings, onLines + " of " + readings);
    assertTrue(speeds / readings < 30, speeds / readings + " px/s");
    assertTrue(greatestWay < 20, "a cluster slid by " + greatestWay + " px");
  }

  @Test
  void aLineWithItsEndsInTheClusterMovesAlongItselfAsWell() {
    read(line(share -> 40 + 10 * share, 30, 60));
    assertTrue(onLines < 0.2 * readings, onLines + " of " + readings);
    assertTrue(speeds / readings > 40, speeds / readings + " px/s");
  }
}
