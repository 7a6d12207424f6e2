package haltere.core.chain;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.junit.jupiter.api.Test;

class ResultOrderTest {
  private record Row(long timeUs, int id) {}

  private final List<Row> out = new ArrayList<>();
  private final ResultOrder.Sorter<Row> sorter =
      new ResultOrder<>(2_000_000, Row::timeUs, Comparator.comparingInt(Row::id)).to(out::add);

  private void take(long... timesUs) {
    for (long timeUs : timesUs) {
      sorter.accept(new Row(timeUs, 1));
    }
  }

  private List<Long> times() {
    return out.stream().map(Row::timeUs).toList();
  }

  @Test
  void lateRowsAreInsertedAtTheirTimes() {
    take(1_000_000, 2_000_000, 500_000, 1_500_000, 3_000_000);
    sorter.finish();
    assertEquals(List.of(500_000L, 1_000_000L, 1_500_000L, 2_000_000L, 3_000_000L), times());
  }

  @Test
  void rowsOfOneTimeAreInTheOrderOfTheirIdentities() {
    sorter.accept(new Row(0, 3));
    sorter.accept(new Row(0, 1));
    sorter.accept(new Row(0, 2));
    sorter.finish();
    assertEquals(List.of(1, 2, 3), out.stream().map(Row::id).toList());
  }

  @Test
  void onlyRowsThatMayBePrecededAreBuffered() {
    take(1_000_000, 2_000_000, 3_500_000);
    assertEquals(List.of(1_000_000L), times());
  }

  @Test
  void clockRestartsKeepTheOrderOfTheRecording() {
    take(9_000_000, 9_500_000, 100_000, 200_000);
    sorter.finish();
    assertEquals(List.of(9_000_000L, 9_500_000L, 100_000L, 200_000L), times());
  }
}
