package haltere.ui.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.event.SensorGeometry;
import java.util.List;
import org.junit.jupiter.api.Test;

class PlotSetTest {
  private static List<String> titles(String... filters) {
    FilterChain chain = new FilterChain(new SensorGeometry(128, 128));
    for (String filter : filters) {
      chain.add(Filters.named(filter));
    }
    List<PlotSet> sets = PlotSet.of(PlotField.of(chain));
    chain.close();
    return sets.stream().map(set -> set.stage() + ": " + set.title()).toList();
  }

  @Test
  void plotSetsContainPublishedColumns() {
    assertEquals(List.of(), titles("background-activity"));
    assertEquals(
        List.of(
            "wing-tracker: Stroke with measurements",
            "wing-tracker: Kalman filter beside running average (method BOTH)",
            "wing-tracker: Left beside right",
            "wing-tracker: Covariance of the stroke",
            "kalman-tracks: Measured and estimated position",
            "kalman-tracks: Covariance and gain",
            "kalman-tracks: Measurement and process variance"),
        titles("wing-tracker", "kalman-tracks"));
  }
}
