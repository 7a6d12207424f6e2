package haltere.filters.road;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.filters.plane.PlanePoint;
import haltere.filters.road.LineCrossing.Direction;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class LineCounterTest {
  private final List<LineCrossing> crossings = new ArrayList<>();
  private final LineCounter counter =
      new LineCounter(
          new LaneSettings(2, -3.5, 3.5), new CountingLineSettings(2, 20, 10), crossings::add);

  private void at(double timeS, int id, double xM, double yM, double sdM) {
    long timeUs = Math.round(timeS * 1e6);
    counter.accept(new PlanePoint(timeUs, id, xM, yM, 0, 10, sdM, sdM, 0.5, 0.5));
  }

  private void drive(int id, double xM, double fromM, double toM) {
    double step = Math.signum(toM - fromM);
    for (int i = 0; i <= Math.abs(toM - fromM); i++) {
      at(0.1 * i, id, xM, fromM + step * i, 0.3);
    }
  }

  @Test
  void crossingIsCountedOnceWithTimeLaneAndSpeed() {
    drive(7, 1, 15.5, 40.5);
    assertEquals(List.of(20.0, 30.0), crossings.stream().map(LineCrossing::lineM).toList());
    LineCrossing first = crossings.get(0);
    assertEquals(new LineCrossing(450_000, 7, 20, Direction.AWAY, 1, 36, 1.8, 1, 0), first);
  }

  @Test
  void countsArePerLaneAndDirection() {
    drive(1, 1, 15.5, 25.5);
    drive(2, 1, 15.5, 25.5);
    drive(3, -1, 15.5, 25.5);
    drive(4, 1, 25.5, 15.5);
    assertEquals(
        List.of("1 1 0", "1 2 0", "0 1 0", "1 2 1"),
        crossings.stream()
            .map(c -> c.lane() + " " + c.countAway() + " " + c.countTowards())
            .toList());
  }

  @Test
  void objectsOnALineAreCountedAfterLeavingIt() {
    Stream.of(19.0, 19.9, 20.1, 19.9, 20.1, 20.3).forEach(yM -> at(yM, 1, 1, yM, 0.3));
    assertEquals(0, crossings.size());
    at(21, 1, 1, 21, 0.3);
    assertEquals(1, crossings.size());
  }

  @Test
  void objectsThatAppearBeyondALineAreNotCounted() {
    drive(1, 1, 21, 29);
    assertEquals(0, crossings.size());
  }

  @Test
  void trackOfUnknownPositionIsOnNoSide() {
    at(0, 1, 1, 10, 30);
    at(1, 1, 1, 25, 30);
    at(2, 1, 1, 27, 0.1);
    assertEquals(0, crossings.size());
  }

  @Test
  void numberOfStoredTracksIsLimited() {
    at(0, 0, 1, 10, 0.1);
    for (int id = 1; id <= 1000; id++) {
      at(1, id, 1, 10, 0.1);
    }
    at(2, 0, 1, 25, 0.1);
    assertEquals(0, crossings.size());
    at(2, 1000, 1, 25, 0.1);
    assertEquals(1, crossings.size());
  }
}
