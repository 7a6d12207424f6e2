package haltere.testing.evaluation;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;

/**
 * How well a tracker does on seeded {@link TrackingScene}s, all of them together.
 *
 * @param scenes how many
 * @param hota {@link HotaScore} with the distance of no similarity of {@link #FAR_PX}
 * @param idf1 {@link IdentityScore} with a gate of {@link #GATE_PX}
 * @param mota CLEAR MOT accuracy at the same gate
 * @param gospaPx mean {@link Gospa} over time with the same gate as its cut-off, pixels
 * @param encounters of two discs with different velocities, both of which had a track before and
 *     are on the sensor after
 * @param keptEncounters those after which both have the same track as before
 * @param switches tracks that took the place of others, wherever that was
 * @param accuracy of positions, and of the velocities of tracks of at least 0.3 s
 * @param medianLatencyUs time from the first row of truth to the first row of a track
 */
public record TrackingScores(
    int scenes,
    double hota,
    double idf1,
    double mota,
    double gospaPx,
    int encounters,
    int keptEncounters,
    long switches,
    Accuracy accuracy,
    double medianLatencyUs) {
  /** Distance from which on a track has nothing to do with an object, pixels. */
  public static final double FAR_PX = 20;

  /** Distance up to which a track stands for an object, pixels. */
  public static final double GATE_PX = 10;

  /** Velocities that differ by less are not different, pixels a second. */
  public static final double DIFFERENT_PX_PER_S = 20;

  private static final long SETTLED_US = 300_000;
  private static final long BEFORE_US = 50_000;
  private static final long AFTER_US = 100_000;

  /**
   * Runs a tracker over scenes.
   *
   * @param firstSeed of the first scene; the others follow
   * @param scenes how many
   * @param tracker gives its rows at the times of the scene (and at no others), having seen what
   *     was before each time and no more
   * @return the scores
   */
  public static TrackingScores of(
      long firstSeed, int scenes, Function<TrackingScene, List<ObjectPoint>> tracker) {
    List<Frames> all = new ArrayList<>();
    int encounters = 0;
    int kept = 0;
    for (int i = 0; i < scenes; i++) {
      TrackingScene scene = TrackingScene.of(firstSeed + i);
      Frames frames = frames(scene, tracker.apply(scene));
      all.add(frames);
      Map<Long, Integer> trackOf = new HashMap<>();
      for (Match match : new Correspondences(frames, GATE_PX).matches()) {
        trackOf.put(key(match.truth().id(), match.truth().timeUs()), match.track().id());
      }
      Set<Long> there = new HashSet<>();
      scene.truth().forEach(point -> there.add(key(point.id(), point.timeUs())));
      for (TrackingScene.Encounter encounter : scene.encounters()) {
        if (encounter.relativeSpeed() >= DIFFERENT_PX_PER_S) {
          Outcome first = outcome(encounter.first(), encounter, trackOf, there);
          Outcome second = outcome(encounter.second(), encounter, trackOf, there);
          if (first != Outcome.UNKNOWN && second != Outcome.UNKNOWN) {
            encounters++;
            kept += first == Outcome.KEPT && second == Outcome.KEPT ? 1 : 0;
          }
        }
      }
    }
    Frames joined = Frames.joined(all);
    Correspondences correspondences = new Correspondences(joined, GATE_PX);
    return new TrackingScores(
        scenes,
        HotaScore.of(joined, FAR_PX).hota(),
        IdentityScore.of(joined, GATE_PX).idf1(),
        correspondences.mota(),
        Gospa.of(joined, GATE_PX).mean(),
        encounters,
        kept,
        correspondences.switches(),
        Accuracy.of(joined, correspondences, SETTLED_US),
        TrackLatency.of(joined, correspondences).medianUs());
  }

  /**
   * Lays truth and tracks side by side, without tracks of discs that are only half on the sensor.
   *
   * @param scene the truth
   * @param rows the tracks
   * @return the frames
   */
  public static Frames frames(TrackingScene scene, List<ObjectPoint> rows) {
    List<ObjectPoint> wanted =
        rows.stream()
            .filter(
                row ->
                    distance(row, scene.halfSeen()) > GATE_PX
                        || distance(row, scene.truth()) < distance(row, scene.halfSeen()))
            .toList();
    return Frames.at(scene.timesUs(), scene.truth(), wanted);
  }

  private static double distance(ObjectPoint row, List<ObjectPoint> points) {
    return points.stream()
        .filter(point -> point.timeUs() == row.timeUs())
        .mapToDouble(row::distanceTo)
        .min()
        .orElse(Double.POSITIVE_INFINITY);
  }

  private enum Outcome {
    UNKNOWN,
    KEPT,
    LOST
  }

  private static Outcome outcome(
      int id, TrackingScene.Encounter encounter, Map<Long, Integer> trackOf, Set<Long> there) {
    Integer before = trackOf.get(key(id, encounter.fromUs() - BEFORE_US));
    Integer after = trackOf.get(key(id, encounter.toUs() + AFTER_US));
    if (before == null || !there.contains(key(id, encounter.toUs() + AFTER_US))) {
      return Outcome.UNKNOWN;
    }
    return before.equals(after) ? Outcome.KEPT : Outcome.LOST;
  }

  private static long key(int id, long timeUs) {
    return timeUs * 1000 + id;
  }

  /**
   * The share of encounters after which both have the track that they had.
   *
   * @return 0 to 1, NaN without encounters
   */
  public double keptShare() {
    return (double) keptEncounters / encounters;
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "%d scenes: HOTA %.4f, IDF1 %.4f, MOTA %.4f, GOSPA %.3f px, %d of %d encounters kept (%.1f %%), "
            + "%d switches, position RMSE %.3f px, velocity RMSE %.2f %% of the speed, "
            + "median latency %.0f ms",
        scenes,
        hota,
        idf1,
        mota,
        gospaPx,
        keptEncounters,
        encounters,
        100 * keptShare(),
        switches,
        accuracy.positionRmse(),
        100 * accuracy.relativeVelocityRmse(),
        medianLatencyUs / 1000);
  }
}
