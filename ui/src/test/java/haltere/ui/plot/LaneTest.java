package haltere.ui.plot;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.FilterChain;
import haltere.core.event.SensorGeometry;
import haltere.core.sink.Column;
import haltere.filters.DefaultChain;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** From rows that filters publish to curves. */
class LaneTest {
  private enum Side {
    LEFT,
    RIGHT
  }

  private record Beat(@Column("t_us") long timeUs, Side side, int beat, double angleRad) {}

  private record NoTime(double x) {}

  private static final PlotField FIELD = new PlotField("wings", "beats", "angle_rad");

  @Test
  void rangeExcludesTheInitialTransient() {
    Lane lane = new Lane(FIELD);
    for (int i = 0; i <= 100; i++) {
      lane.take(FIELD, 10_000L * i, "left", i < 5 ? 1000 : i % 10);
    }
    TimeWindow window = new TimeWindow();
    window.advanceTo(1_000_000);
    assertArrayEquals(new double[] {0, 9}, lane.range(window, 500));
  }

  @Test
  void covarianceIsNamedP() {
    assertEquals("P xvx", new PlotField("tracks", "estimates", "p_xvx").label());
    assertEquals("phase", new PlotField("wing-tracker", "wings", "phase_rad").label());
  }

  @Test
  void rowValuesAreReadByColumn() {
    PlotRow fields = PlotRow.of(Beat.class).orElseThrow();
    Beat row = new Beat(1234, Side.RIGHT, 5, 0.25);
    assertEquals(List.of("beat", "angle_rad"), fields.columns());
    assertEquals(1234, fields.timeUs(row));
    assertEquals("RIGHT", fields.key(row));
    assertEquals(5, fields.value(row, fields.index("beat")));
    assertEquals(0.25, fields.value(row, fields.index("angle_rad")));
  }

  @Test
  void rowsWithoutTimeCannotBePlotted() {
    assertTrue(PlotRow.of(NoTime.class).isEmpty());
    assertTrue(PlotRow.of(String.class).isEmpty());
  }

  @Test
  void resultsOfTheDefaultChainCanBePlotted() {
    FilterChain chain = DefaultChain.create(new SensorGeometry(64, 64));
    List<PlotField> fields = PlotField.of(chain);
    PlotField x = new PlotField("object-tracker", "objects", "x_px");
    assertTrue(fields.contains(x), () -> "only " + fields);
    for (PlotField field : fields) {
      PlotFeed.open(field, chain).orElseThrow().close();
    }
    assertTrue(new PlotField("gone", "objects", "x_px").find(chain).isEmpty());
    assertTrue(PlotFeed.open(new PlotField("object-tracker", "objects", "no"), chain).isEmpty());
  }

  @Test
  void unitOfAValueFollowsFromItsColumnName() {
    Map<String, String> expected =
        Map.of(
            "angle_rad", "rad",
            "vx_px_s", "px/s",
            "x_px", "px",
            "sd_speed_km_h", "km/h",
            "sd_y_m", "m",
            "age_us", "\u00b5s",
            "rate_hz", "Hz",
            "frequency_rad2_per_s2", "rad\u00b2/s\u00b2",
            "mass", "");
    expected.forEach(
        (column, unit) -> assertEquals(unit, new PlotField("a", "b", column).unit(), column));
    Lane lane = new Lane(FIELD);
    lane.add(PlotField.EVENT_RATE);
    lane.take(PlotField.EVENT_RATE, 1, "", 1e6);
    lane.take(FIELD, 1, "LEFT", 1);
    assertEquals(List.of("ev/s", "rad"), lane.curves().stream().map(lane::unit).toList());
  }

  @Test
  void eachKeyHasACurve() {
    Lane lane = new Lane(FIELD);
    lane.take(FIELD, 1, "LEFT", 1);
    lane.take(FIELD, 2, "RIGHT", 2);
    lane.take(FIELD, 3, "LEFT", 3);
    assertEquals(List.of("LEFT", "RIGHT"), lane.curves().stream().map(Curve::key).toList());
    assertEquals(3, lane.lastUs(FIELD));
  }

  @Test
  void restartedCurveKeepsItsColour() {
    Lane lane = new Lane(FIELD);
    for (int run = 0; run < 3; run++) {
      lane.take(FIELD, 100, "left", 1);
      lane.take(FIELD, 100, "right", 1);
      assertEquals(List.of(0, 1), lane.curves().stream().map(Curve::number).toList());
      lane.removeFrom(0);
    }
  }

  @Test
  void longestSilentCurveIsReplaced() {
    Lane lane = new Lane(FIELD);
    for (int i = 0; i < Lane.MAX_CURVES + 5; i++) {
      lane.take(FIELD, i, String.valueOf(i), 1);
      lane.take(FIELD, i, "0", 1);
    }
    assertEquals(Lane.MAX_CURVES, lane.curves().size());
    assertEquals("0", lane.curves().get(0).key());
    assertEquals(Lane.MAX_CURVES, lane.curves(FIELD).size());
  }

  @Test
  void tableContainsTheVisibleSamples() {
    Lane lane = new Lane(FIELD);
    for (int i = 0; i < 10; i++) {
      lane.take(FIELD, i * 1_000_000L, "LEFT", i);
    }
    TimeWindow window = new TimeWindow();
    window.advanceTo(9_000_000);
    String text = Lane.table(List.of(lane), window);
    assertEquals(
        List.of(
            "t_us,field,key,value,lowest,highest",
            "4000000,wings/beats/angle_rad,LEFT,4.0,4.0,4.0"),
        text.lines().limit(2).toList());
    assertEquals(7, text.lines().count());
  }

  @Test
  void windowFollowsUntilItIsScrolled() {
    TimeWindow window = new TimeWindow();
    window.advanceTo(10_000_000);
    assertEquals(5_000_000, window.fromUs());
    window.zoom(0.5, 0);
    assertEquals(7_500_000, window.fromUs());
    window.scroll(-1_000_000);
    window.advanceTo(20_000_000);
    assertEquals(9_000_000, window.toUs());
    long under = window.timeAt(0.25);
    window.zoom(3, 0.25);
    assertEquals(under, window.timeAt(0.25), 2);
    for (int i = 0; i < 100; i++) {
      window.zoom(0.1, 0.5);
    }
    assertEquals(TimeWindow.MIN_SPAN_US, window.spanUs());
  }

  @Test
  void curvesOfLaterTimesAreRemovedWhenPlaybackGoesBack() {
    Lane lane = new Lane(PlotField.EVENT_RATE);
    for (int track = 0; track < Lane.MAX_CURVES; track++) {
      lane.take(PlotField.EVENT_RATE, 1000 * track, "old " + track, 1);
    }
    lane.removeFrom(3000);
    assertEquals(
        List.of("old 0", "old 1", "old 2"), lane.curves().stream().map(Curve::key).toList());
    lane.take(PlotField.EVENT_RATE, 3000, "new", 2);
    lane.take(PlotField.EVENT_RATE, 3001, "newer", 2);
    assertEquals(5, lane.curves().size());
    assertEquals(5, lane.curves(PlotField.EVENT_RATE).size());
  }
}
