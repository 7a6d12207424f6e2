package haltere.testing.evaluation;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.pipeline.Pipeline;
import haltere.core.pipeline.PipelineCounters;
import haltere.core.simulation.road.RoadScene;
import haltere.core.simulation.road.RoadSceneSettings;
import haltere.core.simulation.road.RoadTruth;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.RoadMapping;
import haltere.filters.track.RoadSettings;
import haltere.filters.track.RoadTrackPoint;
import haltere.filters.track.RoadTracksSettings;
import haltere.filters.track.TrackPoint;
import haltere.filters.track.VanishingPoint;
import haltere.filters.track.kalman.KalmanTracksFilter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

/**
 * Speeds of simulated vehicles as Kalman tracks on a road find them, how many tracks a vehicle has,
 * and who is counted at counting lines: {@code ./gradlew :src-test:evaluateRoad}. Everything is as
 * by default, but for what the arguments say, behind background activity and hot pixels. An
 * estimate is compared with the speed of the vehicle itself.
 */
public final class RoadEvaluation {
  private static final long EACH_US = 50_000;
  private static final long COUNTED_EACH_US = 25_000;
  private static final long OLD_ENOUGH_US = 300_000;
  private static final double SEEN_SHARE = 0.95;
  private static final double LEAST_M_S = 3;
  private static final double LEAST_BOX_PX = 8;
  private static final double NEAR_PX = 3;
  private static final int ENOUGH_MOMENTS = 10;

  private final Spread singles = new Spread();
  private final List<Spread> passages = new ArrayList<>();
  private final Spread weighted = new Spread();
  private final List<Double> weightedRatios = new ArrayList<>();
  private final Map<String, int[]> momentsOf = new TreeMap<>();
  private final Spread normalized = new Spread();
  private final RoadHonesty honesty = new RoadHonesty();
  private RoadCounts counts;
  private RoadMapping mapping;
  private int astray;

  /** A track in the picture and on the road. */
  private record At(TrackPoint picture, RoadTrackPoint road) {}

  /** Estimated and true speeds of a vehicle, each by what the estimate says of its certainty. */
  private static final class Passage {
    private int moments;
    private double estimated;
    private double truth;

    void add(RoadTrackPoint at, double trueSpeed) {
      double weight = 1 / (at.sdSpeedKmH() * at.sdSpeedKmH());
      moments++;
      estimated += weight * Math.hypot(at.vxMS(), at.vyMS());
      truth += weight * trueSpeed;
    }
  }

  /**
   * Scores and prints.
   *
   * @param arguments the first seed, the number of scenes, seconds of each, and settings of the
   *     scene such as {@code traffic.pauseS=5}
   */
  public static void main(String[] arguments) {
    long firstSeed = Long.parseLong(arguments[0]);
    int scenes = Integer.parseInt(arguments[1]);
    List<String> settings = List.of(arguments).subList(3, arguments.length);
    System.out.println(of(firstSeed, scenes, arguments[2], settings));
  }

  /** Scores some scenes of so many seconds. */
  static RoadEvaluation of(long firstSeed, int scenes, String seconds, List<String> settings) {
    RoadEvaluation evaluation = new RoadEvaluation();
    for (long seed = firstSeed; seed < firstSeed + scenes; seed++) {
      List<String> all = new ArrayList<>(settings);
      all.add("run.seed=" + seed);
      all.add("run.durationS=" + seconds);
      evaluation.add(RoadSceneSettings.defaults().with(all.toArray(new String[0])));
    }
    return evaluation;
  }

  /** Whether tracks are as sure as they say. */
  RoadHonesty honesty() {
    return honesty;
  }

  private void add(RoadSceneSettings settings) {
    RoadScene scene = new RoadScene(settings);
    Map<Long, List<At>> tracks = tracks(scene);
    countCrossings(scene);
    Map<Integer, Spread> ratios = new HashMap<>();
    Map<Integer, Passage> certain = new HashMap<>();
    Map<Integer, Long> begun = new HashMap<>();
    for (Map.Entry<Long, List<At>> moment : tracks.entrySet()) {
      long timeUs = moment.getKey();
      moment.getValue().forEach(at -> begun.putIfAbsent(at.picture().id(), timeUs));
      if (timeUs % EACH_US != 0) {
        continue;
      }
      List<RoadTruth> vehicles = scene.truthRows(timeUs);
      Map<Integer, Integer> held = new HashMap<>();
      for (At at : moment.getValue()) {
        RoadTruth vehicle = nearest(at.picture(), vehicles);
        if (vehicle == null) {
          astray++;
          continue;
        }
        held.merge(vehicle.id(), 1, Integer::sum);
        boolean old = timeUs - begun.get(at.picture().id()) >= OLD_ENOUGH_US;
        double speed = Math.hypot(vehicle.vxMS(), vehicle.vyMS());
        if (old && vehicle.visibleShare() >= SEEN_SHARE && speed > LEAST_M_S) {
          double ratio = Math.hypot(at.road().vxMS(), at.road().vyMS()) / speed;
          singles.add(ratio);
          double error = at.road().speedKmH() - 3.6 * speed;
          normalized.add(error * error / (at.road().sdSpeedKmH() * at.road().sdSpeedKmH()));
          honesty.add(at.road(), vehicle, mapping);
          ratios.computeIfAbsent(vehicle.id(), id -> new Spread()).add(ratio);
          certain.computeIfAbsent(vehicle.id(), id -> new Passage()).add(at.road(), speed);
        }
      }
      vehicles.forEach(vehicle -> countTracks(vehicle, held.getOrDefault(vehicle.id(), 0)));
    }
    honesty.endScene();
    certain.values().stream()
        .filter(passage -> passage.moments >= ENOUGH_MOMENTS)
        .map(passage -> passage.estimated / passage.truth)
        .forEach(
            ratio -> {
              weighted.add(ratio);
              weightedRatios.add(ratio);
            });
    passages.addAll(
        ratios.values().stream().filter(spread -> spread.count() >= ENOUGH_MOMENTS).toList());
  }

  private void countCrossings(RoadScene scene) {
    long endUs = Math.round(scene.settings().run().durationS() * 1e6);
    for (long timeUs = 0; timeUs < endUs; timeUs += COUNTED_EACH_US) {
      counts.see(timeUs, scene.truthRows(timeUs));
    }
    counts.endScene();
  }

  private Map<Long, List<At>> tracks(RoadScene scene) {
    var camera = scene.settings().camera();
    RoadSettings view =
        new RoadSettings(
            camera.bridgeHeightM(),
            camera.bottomRowM(),
            camera.vanishingRowM(),
            VanishingPoint.at(scene.vanishingXPx(), scene.vanishingYPx()));
    RoadTracksSettings road =
        new RoadTracksSettings(
            true,
            view,
            RoadTracksSettings.defaults().processVariance(),
            RoadCounts.LANES,
            RoadCounts.LINES);
    KalmanTracksFilter filter =
        new KalmanTracksFilter(scene.geometry(), KalmanTracksSettings.defaults().onRoad(road));
    if (counts == null) {
      mapping = new RoadMapping(view, scene.geometry());
      counts = new RoadCounts(mapping);
    }
    filter.crossings().subscribe(counts::count);
    filter.updates().subscribe(honesty::add);
    FilterChain chain = new FilterChain(scene.geometry());
    chain.add(Filters.named("background-activity"));
    chain.add(Filters.named("hot-pixels"));
    chain.add("kalman-tracks", filter);
    Map<Long, List<At>> tracks = new TreeMap<>();
    TrackPoint[] inPicture = new TrackPoint[1];
    // A track's place in the picture is published before its place on the road.
    filter.points().subscribe(point -> inPicture[0] = point);
    filter
        .roadPoints()
        .subscribe(
            onRoad ->
                tracks
                    .computeIfAbsent(onRoad.timeUs(), time -> new ArrayList<>())
                    .add(new At(inPicture[0], onRoad)));
    try {
      Pipeline.run(scene, chain, List.of(), new PipelineCounters());
    } catch (IOException impossible) {
      throw new UncheckedIOException(impossible);
    }
    chain.close();
    return tracks;
  }

  /** The vehicle in whose box a track is, by its lower edge if there are several, or null. */
  private static RoadTruth nearest(TrackPoint track, List<RoadTruth> vehicles) {
    RoadTruth best = null;
    double least = Double.POSITIVE_INFINITY;
    for (RoadTruth vehicle : vehicles) {
      double aside = Math.abs(vehicle.xPx() - track.xPx());
      double above = Math.abs(vehicle.yPx() - track.yPx());
      double fromEdge = track.yPx() - vehicle.yPx() + vehicle.heightPx() / 2;
      double distance = Math.hypot(aside, fromEdge);
      if (aside < vehicle.widthPx() / 2 + NEAR_PX
          && above < vehicle.heightPx() / 2 + NEAR_PX
          && distance < least) {
        least = distance;
        best = vehicle;
      }
    }
    return best;
  }

  private static double longerSide(RoadTruth vehicle) {
    return Math.max(vehicle.widthPx(), vehicle.heightPx());
  }

  private void countTracks(RoadTruth vehicle, int tracks) {
    if (vehicle.visibleShare() >= SEEN_SHARE && longerSide(vehicle) >= LEAST_BOX_PX) {
      String kind = vehicle.kind().name().toLowerCase(Locale.ROOT);
      momentsOf.computeIfAbsent(kind, name -> new int[3])[Math.min(2, tracks)]++;
      if (Math.hypot(vehicle.vxMS(), vehicle.vyMS()) <= LEAST_M_S) {
        momentsOf.computeIfAbsent("standing", name -> new int[3])[Math.min(2, tracks)]++;
      }
    }
  }

  @Override
  public String toString() {
    StringBuilder text = new StringBuilder();
    Spread means = new Spread();
    passages.forEach(passage -> means.add(passage.mean()));
    line(
        text,
        "speed: bias %.2f %%, standard deviation of single estimates %.1f %% (%d), of the mean over"
            + " a passage %.1f %% (%d, bias %.2f %%)",
        100 * (singles.mean() - 1),
        100 * singles.sd(),
        singles.count(),
        100 * means.sd(),
        means.count(),
        100 * (means.mean() - 1));
    line(
        text,
        "mean over a passage weighted by 1/variance: bias %.2f %%, standard deviation %.1f %%",
        100 * (weighted.mean() - 1),
        100 * weighted.sd());
    weightedRatios.sort(null);
    line(
        text,
        "half of these are between %.1f and %.1f %%",
        100 * (quantile(0.25) - 1),
        100 * (quantile(0.75) - 1));
    momentsOf.forEach(
        (kind, moments) ->
            line(
                text,
                "%s, %d moments in full view: no track in %.1f %%, one in %.1f %%, more in %.1f %%",
                kind,
                moments[0] + moments[1] + moments[2],
                share(moments, 0),
                share(moments, 1),
                share(moments, 2)));
    line(text, "moments of tracks that are on no vehicle: %d", astray);
    line(text, "mean squared error of single estimates over the stated: %.2f", normalized.mean());
    return text.append(honesty).append(counts).toString();
  }

  private double quantile(double share) {
    return weightedRatios.isEmpty()
        ? Double.NaN
        : weightedRatios.get((int) (share * (weightedRatios.size() - 1)));
  }

  private static double share(int[] moments, int which) {
    return 100.0 * moments[which] / (moments[0] + moments[1] + moments[2]);
  }

  private static void line(StringBuilder text, String format, Object... values) {
    text.append(String.format(Locale.ROOT, format, values)).append(System.lineSeparator());
  }
}
