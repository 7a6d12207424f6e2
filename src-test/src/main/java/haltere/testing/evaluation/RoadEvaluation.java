package haltere.testing.evaluation;

import haltere.core.chain.FilterChain;
import haltere.core.simulation.internal.road.RoadCameraSettings;
import haltere.core.simulation.internal.road.RoadScene;
import haltere.core.simulation.internal.road.RoadSceneSettings;
import haltere.core.simulation.internal.road.RoadTruth;
import haltere.filters.object.ObjectTrack;
import haltere.filters.object.ObjectTrackerFilter;
import haltere.filters.object.ObjectTrackerSettings;
import haltere.filters.plane.RoadMapping;
import haltere.filters.plane.RoadViewSettings;
import haltere.filters.plane.VanishingPoint;
import haltere.filters.road.CountingLineSettings;
import haltere.filters.road.LaneSettings;
import haltere.filters.road.LineCounter;
import haltere.filters.road.LineCrossing;
import haltere.filters.road.RoadMotion;
import haltere.filters.road.VehiclePrior;
import haltere.filters.road.VehiclesOnRoad;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleFunction;

/**
 * Counts and speeds of vehicles that cross lines at 20 m and 40 m of simulated roads, as {@code
 * haltere track --road} finds them, against those of the simulator. A crossing that was found is
 * that of a vehicle if both have one direction, lanes that differ by at most one, and times that
 * differ by less than a second; those in one lane first, then the nearest in time.
 */
public final class RoadEvaluation {
  /** Counting lines of all scenes. */
  public static final CountingLineSettings LINES = new CountingLineSettings(2, 20, 20);

  /** Lanes of all scenes. */
  public static final LaneSettings LANES = new LaneSettings(4, -7, 3.5);

  private static final double MATCH_S = 1;
  private static final double SECONDS = 30;
  private static final int STEP_US = 10_000;

  /** Two standard deviations of a normal distribution hold this factor of 95 %. */
  private static final double IN_95 = 1.96;

  /** A vehicle that crosses a line. */
  record Crossing(double lineM, double s, boolean away, int lane, double kmH, double sdKmH) {}

  /** A crossing that was found and the true one. */
  record Pair(Crossing found, Crossing truth) {
    double apartS() {
      return Math.abs(found.s - truth.s);
    }

    int lanesApart() {
      return Math.abs(found.lane - truth.lane);
    }

    double error() {
      return (found.kmH - truth.kmH) / truth.kmH;
    }

    boolean isIn95() {
      return Math.abs(found.kmH - truth.kmH) < IN_95 * found.sdKmH;
    }
  }

  private final List<Crossing> truths = new ArrayList<>();
  private final List<Crossing> found = new ArrayList<>();
  private final List<Pair> pairs = new ArrayList<>();

  /**
   * Judges and prints a line.
   *
   * @param arguments first seed, scenes, then settings of the scene
   * @throws IOException never, for nothing is read
   */
  public static void main(String[] arguments) throws IOException {
    RoadEvaluation evaluation = new RoadEvaluation();
    long first = Long.parseLong(arguments[0]);
    String[] assignments = new String[arguments.length - 2];
    System.arraycopy(arguments, 2, assignments, 0, assignments.length);
    for (long seed = first; seed < first + Integer.parseInt(arguments[1]); seed++) {
      evaluation.judge(
          RoadSceneSettings.defaults()
              .with(assignments)
              .with("run.seed=" + seed, "run.durationS=" + SECONDS));
    }
    System.out.println(evaluation);
  }

  /** {@return the mapping of the camera of a scene} */
  public static RoadMapping mapping(RoadScene scene) {
    RoadCameraSettings camera = scene.settings().camera();
    return new RoadMapping(
        new RoadViewSettings(
            camera.bridgeHeightM(),
            camera.bottomRowM(),
            camera.vanishingRowM(),
            VanishingPoint.at(scene.vanishingXPx(), scene.vanishingYPx())),
        scene.geometry());
  }

  /** Tracks a scene. */
  void judge(RoadSceneSettings settings) throws IOException {
    RoadScene scene = new RoadScene(settings);
    RoadMapping mapping = mapping(scene);
    VehiclePrior prior = VehiclePrior.defaults();
    ObjectTrackerFilter tracker =
        new ObjectTrackerFilter(scene.geometry(), ObjectTrackerSettings.defaults());
    tracker.apply(new RoadMotion(mapping, prior));
    List<ObjectTrack> rows = new ArrayList<>();
    tracker.tracks().subscribe(rows::add);
    FilterChain chain = new FilterChain(scene.geometry());
    chain.add("object-tracker", tracker);
    scene.drainTo(chain);
    chain.close();
    List<Crossing> here = new ArrayList<>();
    VehiclesOnRoad vehicles = new VehiclesOnRoad(mapping, prior);
    LineCounter counter = new LineCounter(LANES, LINES, crossing -> here.add(of(crossing)));
    rows.sort(Comparator.comparingLong(ObjectTrack::timeUs));
    rows.forEach(row -> vehicles.apply(row).ifPresent(counter));
    match(here, truth(scene));
  }

  private static Crossing of(LineCrossing crossing) {
    return new Crossing(
        crossing.lineM(),
        crossing.timeUs() * 1e-6,
        crossing.direction() == LineCrossing.Direction.AWAY,
        crossing.lane(),
        crossing.speedKmH(),
        crossing.sdSpeedKmH());
  }

  private static List<Crossing> truth(RoadScene scene) {
    List<Crossing> crossings = new ArrayList<>();
    Map<Integer, Double> before = new HashMap<>();
    for (long us = 0; us < SECONDS * 1e6; us += STEP_US) {
      for (RoadTruth row : scene.truthRows(us)) {
        Double last = before.put(row.id(), row.yM());
        for (int line = 0; line < LINES.lines() && last != null; line++) {
          double lineM = LINES.distanceM(line);
          if (last > lineM != row.yM() > lineM) {
            crossings.add(
                new Crossing(
                    lineM, us * 1e-6, row.vyMS() > 0, row.lane(), 3.6 * Math.abs(row.vyMS()), 0));
          }
        }
      }
    }
    return crossings;
  }

  private void match(List<Crossing> here, List<Crossing> truth) {
    List<Pair> possible = new ArrayList<>();
    for (Crossing one : here) {
      for (Crossing other : truth) {
        Pair pair = new Pair(one, other);
        if (one.lineM == other.lineM
            && one.away == other.away
            && pair.lanesApart() <= 1
            && pair.apartS() < MATCH_S) {
          possible.add(pair);
        }
      }
    }
    possible.sort(Comparator.comparingInt(Pair::lanesApart).thenComparingDouble(Pair::apartS));
    while (!possible.isEmpty()) {
      Pair nearest = possible.get(0);
      pairs.add(nearest);
      possible.removeIf(pair -> pair.found == nearest.found || pair.truth == nearest.truth);
    }
    found.addAll(here);
    truths.addAll(truth);
  }

  /** Share of the true crossings that were found. */
  double foundShare() {
    return (double) pairs.size() / truths.size();
  }

  private static double median(List<Pair> of, ToDoubleFunction<Pair> value) {
    double[] sorted = of.stream().mapToDouble(value).sorted().toArray();
    return sorted.length == 0 ? Double.NaN : sorted[sorted.length / 2];
  }

  /** Median of the errors of speeds without their signs, as a share of the speeds. */
  double medianError() {
    return median(pairs, pair -> Math.abs(pair.error()));
  }

  @Override
  public String toString() {
    double bias = median(pairs, Pair::error);
    double mean = pairs.stream().mapToDouble(Pair::error).average().orElse(Double.NaN);
    double variance =
        pairs.stream()
            .mapToDouble(p -> (p.error() - mean) * (p.error() - mean))
            .average()
            .orElse(0);
    return String.format(
        Locale.ROOT,
        "crossings %d, counted %d, of them within 1 s of a true one %d; speeds: median error %.1f %%,"
            + " median %+.1f %%, sd %.1f %% (1.48 MAD %.1f %%), stated %.1f %%, %.0f %% in 95 %%",
        truths.size(),
        found.size(),
        pairs.size(),
        100 * medianError(),
        100 * bias,
        100 * Math.sqrt(variance),
        148.26 * median(pairs, pair -> Math.abs(pair.error() - bias)),
        100 * median(pairs, pair -> pair.found.sdKmH / pair.truth.kmH),
        100.0 * pairs.stream().filter(Pair::isIn95).count() / Math.max(1, pairs.size()));
  }
}
