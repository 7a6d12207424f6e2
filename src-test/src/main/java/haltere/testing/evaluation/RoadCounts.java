package haltere.testing.evaluation;

import haltere.core.simulation.road.RoadTruth;
import haltere.filters.track.CountingLineSettings;
import haltere.filters.track.LaneSettings;
import haltere.filters.track.LineCrossing;
import haltere.filters.track.RoadMapping;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.NavigableMap;
import java.util.TreeMap;

/**
 * Compares who has crossed counting lines with who was counted there. A vehicle crosses a line when
 * its end that is nearer to the camera does; one that does so within the first second and a half,
 * before anybody could know it, is not asked for. What the camera cannot see is told apart: a
 * vehicle of which at no moment about the crossing half is visible, by the scene's own truth. If it
 * is counted nevertheless that is no mistake.
 */
final class RoadCounts {
  static final LaneSettings LANES = new LaneSettings(4, -7, 3.5);
  static final CountingLineSettings LINES = new CountingLineSettings(3, 20, 8);

  private static final long FROM_US = 1_500_000;
  private static final long NEAR_US = 700_000;
  private static final double NEAR_M = 2.7;
  private static final double FAST_SHARE = 0.1;
  private static final double HORIZON_PX = 1;
  private static final double HIDDEN_SHARE = 0.5;

  private record Passed(int line, long timeUs, RoadTruth vehicle, boolean away) {}

  private final RoadMapping mapping;
  private final List<Passed> passed = new ArrayList<>();
  private final List<LineCrossing> counted = new ArrayList<>();
  private final Map<Integer, Double> nearEnds = new HashMap<>();

  /** How much of each vehicle was visible when. */
  private final Map<Integer, NavigableMap<Long, Double>> visible = new HashMap<>();

  /** Of each kind: crossings, those missed, those with another speed, those that were hidden. */
  private final Map<String, int[]> kinds = new TreeMap<>();

  private final CrossingSpeeds speeds = new CrossingSpeeds();
  private int surplus;

  RoadCounts(RoadMapping mapping) {
    this.mapping = mapping;
  }

  /** Takes the truth at a time, in the order of time. */
  void see(long timeUs, List<RoadTruth> vehicles) {
    for (RoadTruth vehicle : vehicles) {
      visible
          .computeIfAbsent(vehicle.id(), id -> new TreeMap<>())
          .put(timeUs, vehicle.visibleShare());
      double now = distanceM(vehicle.yPx() - vehicle.heightPx() / 2);
      Double before = nearEnds.put(vehicle.id(), now);
      for (int i = 0; before != null && timeUs >= FROM_US && i < LINES.lines(); i++) {
        double line = LINES.distanceM(i);
        if (before < line != now < line) {
          passed.add(new Passed(i, timeUs, vehicle, now > before));
        }
      }
    }
  }

  /** Of a row at the horizon very far, of one that looks back from the camera none at all. */
  private double distanceM(double row) {
    if (row > mapping.vanishingY() - HORIZON_PX) {
      return Double.MAX_VALUE;
    }
    return mapping.onRoad(row) ? mapping.distanceM(row) : 0;
  }

  /** Takes a crossing that was counted. */
  void count(LineCrossing crossing) {
    counted.add(crossing);
  }

  /** Ends a scene. */
  void endScene() {
    for (Passed one : passed) {
      String kind = one.vehicle.kind().name().toLowerCase(Locale.ROOT);
      int[] sums = kinds.computeIfAbsent(kind, name -> new int[4]);
      LineCrossing match = match(one);
      counted.remove(match);
      if (isHidden(one)) {
        sums[3]++;
        continue;
      }
      sums[0]++;
      if (match == null) {
        sums[1]++;
      } else {
        double speed = 3.6 * Math.hypot(one.vehicle.vxMS(), one.vehicle.vyMS());
        speeds.add(match.speedKmH(), match.sdSpeedKmH(), speed);
        sums[2] += Math.abs(match.speedKmH() - speed) > FAST_SHARE * speed ? 1 : 0;
      }
    }
    surplus += counted.stream().filter(crossing -> crossing.timeUs() >= FROM_US).count();
    counted.clear();
    visible.clear();
    passed.clear();
    nearEnds.clear();
  }

  private boolean isHidden(Passed one) {
    return visible
        .get(one.vehicle.id())
        .subMap(one.timeUs - NEAR_US, one.timeUs + NEAR_US)
        .values()
        .stream()
        .allMatch(share -> share < HIDDEN_SHARE);
  }

  private LineCrossing match(Passed one) {
    LineCrossing best = null;
    for (LineCrossing crossing : counted) {
      double laneM = LANES.leftEdgeM() + (crossing.lane() + 0.5) * LANES.widthM();
      long apart = Math.abs(crossing.timeUs() - one.timeUs);
      if (Math.abs(crossing.lineM() - LINES.distanceM(one.line)) < 0.1
          && (crossing.direction() == LineCrossing.Direction.AWAY) == one.away
          && Math.abs(laneM - one.vehicle.xM()) < NEAR_M
          && apart < NEAR_US
          && (best == null || apart < Math.abs(best.timeUs() - one.timeUs))) {
        best = crossing;
      }
    }
    return best;
  }

  @Override
  public String toString() {
    StringBuilder text = new StringBuilder();
    kinds.forEach(
        (kind, sums) ->
            text.append(
                String.format(
                    Locale.ROOT,
                    "counting lines, %s: %d crossings, %d missed, speed of %d more than 10 %% off;"
                        + " %d more hidden%n",
                    kind,
                    sums[0],
                    sums[1],
                    sums[2],
                    sums[3])));
    return text
        + String.format(Locale.ROOT, "counted though nobody crossed: %d%n", surplus)
        + speeds;
  }
}
