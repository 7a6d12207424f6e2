package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.filters.object.ObjectTrack;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class OrderedTracksTest {
  private final List<Long> out = new ArrayList<>();
  private final OrderedTracks ordered = new OrderedTracks(track -> out.add(track.timeUs()));

  private void take(long... timesUs) {
    for (long timeUs : timesUs) {
      ordered.accept(new ObjectTrack(timeUs, 1, 0, 0, 0, 0, 1, 1, 1, 1, 0, 1, 1, 0, 1, 0, 0, 0));
    }
  }

  @Test
  void rowsOfALateDecisionComeAtTheirTimes() {
    take(1_000_000, 2_000_000, 500_000, 1_500_000, 3_000_000);
    ordered.finish();
    assertEquals(List.of(500_000L, 1_000_000L, 1_500_000L, 2_000_000L, 3_000_000L), out);
  }

  @Test
  void noMoreThanTwoSecondsAreHeld() {
    take(1_000_000, 2_000_000, 3_500_000);
    assertEquals(List.of(1_000_000L), out);
  }

  @Test
  void aClockThatBeginsAnewKeepsTheOrderOfTheRecording() {
    take(9_000_000, 9_500_000, 100_000, 200_000);
    ordered.finish();
    assertEquals(List.of(9_000_000L, 9_500_000L, 100_000L, 200_000L), out);
  }
}
