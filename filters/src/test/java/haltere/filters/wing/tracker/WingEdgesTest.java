package haltere.filters.wing.tracker;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.filters.estimation.Angles;
import haltere.filters.wing.WingBeat;
import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingListener;
import haltere.filters.wing.WingMeasurement;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingResult;
import haltere.filters.wing.WingTrackerSettings;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Results of each edge, and of a wing with only one edge enabled. */
class WingEdgesTest {
  private static final String[] FLY = {
    "disturbances.manoeuvres.everyS=0", "fly.wing.visibleShare=0.15", "stroke.beat.frequencyHz=232"
  };

  private static WingTrackerSettings settings(String method, String... more) {
    WingTrackerSettings start =
        method.startsWith("original")
            ? WingTrackerSettings.original()
            : WingTrackerSettings.defaults();
    String rest = method.replace("original", "");
    List<String> all = new ArrayList<>(List.of(more));
    all.add(Flies.LATENCY);
    if (!rest.isEmpty()) {
      all.add(rest.trim());
    }
    return start.with(all.toArray(String[]::new));
  }

  private static List<WingEstimate> late(TrackerOutput output, WingPart part) {
    return output.of(part).stream().filter(e -> e.timeUs() > 250_000).toList();
  }

  private static double angleDeg(TrackerOutput output, FlyScene truth) {
    double squares = 0;
    List<WingEstimate> late = late(output, WingPart.LEFT);
    for (WingEstimate e : late) {
      squares +=
          Math.pow(Angles.wrapPi(e.angleRad() - truth.truthAt(e.timeUs()).leftAngleRad()), 2);
    }
    assertTrue(late.size() > 300, late.size() + " estimates");
    return Math.toDegrees(Math.sqrt(squares / late.size()));
  }

  private static long beats(TrackerOutput output) {
    return output.beats.stream()
        .filter(b -> b.side() == WingPart.LEFT && b.timeUs() > 250_000)
        .count();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "filter.model=WINGS",
        "filter.model=EDGES",
        "filter.method=WRA",
        "filter.method=BOTH",
        "original",
        "original filter.method=WRA"
      })
  void disabledEdgesAreIgnoredAndTheOtherTracksTheWing(String method) {
    EventPacket fly = Flies.events(0.6, FLY);
    FlyScene truth = Flies.scene(FLY);
    TrackerOutput both = TrackerOutput.of(fly, settings(method));
    double usual = angleDeg(both, truth);
    for (WingPart off : new WingPart[] {WingPart.LEFT_LEADING, WingPart.LEFT_TRAILING}) {
      boolean leading = off == WingPart.LEFT_LEADING;
      String switched = "output.left" + (leading ? "Leading" : "Trailing") + "=false";
      TrackerOutput one = TrackerOutput.of(fly, settings(method, switched));
      WingPart on = leading ? WingPart.LEFT_TRAILING : WingPart.LEFT_LEADING;
      assertTrue(one.of(off).isEmpty());
      assertEquals(one.last(on).events(), one.last(WingPart.LEFT).events());
      assertTrue(one.last(WingPart.RIGHT_LEADING).events() > 100);
      double angle = angleDeg(one, truth);
      assertTrue(angle <= 1.5 * usual, off + " off: " + angle + " degrees, both " + usual);
      assertEquals(beats(both), beats(one), 1, off + " off: beats");
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"Leading", "Trailing"})
  void bothWingsAreTrackedByOneEdge(String off) {
    EventPacket fly = Flies.events(0.6, FLY);
    FlyScene truth = Flies.scene(FLY);
    double usual = angleDeg(TrackerOutput.of(fly, settings("")), truth);
    String[] switched = {"output.left" + off + "=false", "output.right" + off + "=false"};
    TrackerOutput output = TrackerOutput.of(fly, settings("", switched));
    double angle = angleDeg(output, truth);
    assertTrue(angle <= 2 * usual, angle + " degrees, both " + usual);
    assertTrue(beats(output) > 75, beats(output) + " beats");
  }

  @Test
  void wingWithoutEdgesDoesNotDisturbTheOther() {
    EventPacket fly = Flies.events(0.6, FLY);
    long usual = beats(TrackerOutput.of(fly, settings("")));
    String[] off = {"output.rightLeading=false", "output.rightTrailing=false"};
    TrackerOutput one = TrackerOutput.of(fly, settings("", off));
    assertEquals(usual, beats(one), 1);
    assertTrue(one.last(WingPart.LEFT).events() > 10_000, one.last(WingPart.LEFT).toString());
    assertTrue(late(one, WingPart.RIGHT).isEmpty());
  }

  @ParameterizedTest
  @CsvSource({"WINGS, 0", "WINGS, 1", "EDGES, 0", "EDGES, 1"})
  void edgesWithoutEventsCountAsDisabled(String model, int polarity) {
    EventPacket fly = Flies.events(0.6, FLY);
    FlyScene truth = Flies.scene(FLY);
    WingTrackerSettings settings = settings("filter.model=" + model);
    double usual = angleDeg(TrackerOutput.of(fly, settings), truth);
    EventPacket part = new EventPacket(0);
    for (int i = 0; i < fly.size(); i++) {
      if (fly.timeUs(i) < 100_000 || (fly.isOn(i) ? 1 : 0) == polarity) {
        part.append(fly.timeUs(i), fly.address(i));
      }
    }
    TrackerOutput output = TrackerOutput.of(part, settings);
    double angle = angleDeg(output, truth);
    assertTrue(angle <= 2 * usual, angle + " degrees, both " + usual);
    assertTrue(beats(output) > 75, beats(output) + " beats");
  }

  @ParameterizedTest
  @ValueSource(strings = {"filter.model=EDGES", "original"})
  void resultsOfAnEdgeAreThoseOfItsFilter(String method) {
    TrackerOutput output = TrackerOutput.of(Flies.events(0.3, FLY), settings(method));
    WingTracker tracker = output.tracker;
    // a tick at the very end, so that the filters are as they were told
    long atUs = output.last(WingPart.LEFT).timeUs() + 1000;
    tracker.track(EventPacket.of(new long[] {atUs}, new int[] {0}));
    for (WingFilterState filter : tracker.filters()) {
      WingEstimate edge = output.last(filter.part());
      assertEquals(atUs, edge.timeUs());
      assertEquals(filter.x().get(0), edge.centreRad());
      assertEquals(filter.x().get(1), edge.amplitudeRad());
      assertEquals(filter.x().get(3) / (2 * Math.PI), edge.frequencyHz());
      assertEquals(Math.sqrt(filter.p().get(15)) / (2 * Math.PI), edge.sdFrequencyHz());
      assertEquals(filter.events(), edge.events());
    }
    assertEdgesDiffer(output);
    for (WingPart wing : new WingPart[] {WingPart.LEFT, WingPart.RIGHT}) {
      WingEstimate leading = output.last(WingPart.edge(wing.sideNumber(), 0));
      WingEstimate trailing = output.last(WingPart.edge(wing.sideNumber(), 1));
      WingEstimate mean = output.last(wing);
      assertEquals((leading.centreRad() + trailing.centreRad()) / 2, mean.centreRad(), 1e-9);
      assertEquals(
          (leading.amplitudeRad() + trailing.amplitudeRad()) / 2, mean.amplitudeRad(), 1e-9);
      assertEquals((leading.frequencyHz() + trailing.frequencyHz()) / 2, mean.frequencyHz(), 1e-9);
      double half = Math.hypot(leading.sdAngleRad(), trailing.sdAngleRad()) / 2;
      assertEquals(half, mean.sdAngleRad(), 1e-9);
    }
  }

  private static void assertEdgesDiffer(TrackerOutput output) {
    List<WingEstimate> leading = late(output, WingPart.LEFT_LEADING);
    List<WingEstimate> trailing = late(output, WingPart.LEFT_TRAILING);
    assertEquals(leading.size(), trailing.size());
    for (int i = 0; i < leading.size(); i++) {
      WingEstimate a = leading.get(i);
      WingEstimate b = trailing.get(i);
      assertNotEquals(a.angleRad(), b.angleRad());
      assertNotEquals(a.centreRad(), b.centreRad());
      assertNotEquals(a.amplitudeRad(), b.amplitudeRad());
      assertNotEquals(a.phaseRad(), b.phaseRad());
      assertNotEquals(a.frequencyHz(), b.frequencyHz());
    }
  }

  @Test
  void runningAverageHasResultsForEachEdge() {
    assertEdgesDiffer(TrackerOutput.of(Flies.events(0.3, FLY), settings("filter.method=WRA")));
  }

  @Test
  void edgesOfAWingFilterLieHalfAWidthFromIt() {
    TrackerOutput output = TrackerOutput.of(Flies.events(0.3, FLY), settings("filter.model=WINGS"));
    WingEstimate wing = output.last(WingPart.LEFT);
    WingEstimate leading = output.last(WingPart.LEFT_LEADING);
    WingEstimate trailing = output.last(WingPart.LEFT_TRAILING);
    double width = leading.amplitudeRad() - wing.amplitudeRad();
    assertEquals(0.03, width, 0.012);
    assertEquals(wing.amplitudeRad() - width, trailing.amplitudeRad(), 1e-9);
    assertEquals(width, Math.abs(leading.angleRad() - wing.angleRad()), 1e-9);
    assertEquals(2 * wing.angleRad(), leading.angleRad() + trailing.angleRad(), 1e-9);
    for (WingEstimate edge : List.of(leading, trailing)) {
      assertEquals(wing.centreRad(), edge.centreRad());
      assertEquals(wing.phaseRad(), edge.phaseRad());
      assertEquals(wing.frequencyHz(), edge.frequencyHz());
      assertNotEquals(wing.sdAngleRad(), edge.sdAngleRad(), "with what is not known of the width");
    }
  }

  @Test
  void measurementsCarryTheStateOfTheirEdge() {
    EventPacket fly = Flies.events(0.12, FLY);
    List<WingMeasurement> rows = new ArrayList<>();
    WingListener listener =
        new WingListener() {
          @Override
          public boolean isRequested(Class<? extends WingResult> kind) {
            return kind == WingMeasurement.class;
          }

          @Override
          public void accept(WingResult result) {
            if (result instanceof WingMeasurement row) {
              rows.add(row);
            }
          }
        };
    WingTracker tracker =
        new WingTracker(TrackerOutput.SENSOR, settings("filter.model=EDGES"), listener);
    tracker.track(fly);
    for (WingFilterState filter : tracker.filters()) {
      WingMeasurement last =
          rows.stream().filter(m -> m.edge() == filter.part()).reduce((a, b) -> b).orElseThrow();
      assertEquals(filter.x().get(0), last.centreRad(), 1e-12);
      assertEquals(filter.x().get(1), last.amplitudeRad(), 1e-12);
    }
  }

  @Test
  void combinedMethodsYieldTheResultsOfEachAlone() {
    EventPacket fly = Flies.events(0.35, FLY);
    String[] follow = {"average.bodyUpdate=true", "average.headingUpdate=true"};
    TrackerOutput average = TrackerOutput.of(fly, settings("filter.method=WRA", follow));
    TrackerOutput filter = TrackerOutput.of(fly, settings("filter.method=EKF"));
    TrackerOutput both = TrackerOutput.of(fly, settings("filter.method=BOTH", follow));
    List<WingEstimate> wings =
        average.estimates.stream()
            .filter(e -> e.edge() == WingPart.LEFT || e.edge() == WingPart.RIGHT)
            .toList();
    assertTrue(wings.size() > 500);
    assertEquals(wings, both.averages);
    assertEquals(filter.estimates, both.estimates);
    assertEquals(filter.beats, both.beats);
    TrackerOutput still = TrackerOutput.of(fly, settings("filter.method=BOTH"));
    assertNotEquals(still.averages, both.averages, "the body moves with the beats");
    WingBeat last = average.beats.get(average.beats.size() - 1);
    assertEquals(232, last.frequencyHz(), 20);
  }

  @Test
  void beatsMoveTheBodyOfBothMethodsWithEdgeFilters() {
    EventPacket fly = Flies.events(0.35, FLY);
    String[] follow = {"average.bodyUpdate=true", "filter.model=EDGES"};
    for (String method : new String[] {"filter.method=BOTH", "filter.method=EKF"}) {
      TrackerOutput moved = TrackerOutput.of(fly, settings(method, follow));
      double x = moved.tracker.geometry().orElseThrow().centreX();
      double y = moved.tracker.geometry().orElseThrow().centreY();
      double away = Math.hypot(x - moved.geometry.centreX(), y - moved.geometry.centreY());
      assertTrue(away > 0.5, method + ": moved by " + away + " px");
    }
  }
}
