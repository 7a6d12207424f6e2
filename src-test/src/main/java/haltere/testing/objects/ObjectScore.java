package haltere.testing.objects;

import haltere.filters.estimation.Gate;
import haltere.testing.evaluation.Accuracy;
import haltere.testing.evaluation.Correspondences;
import haltere.testing.evaluation.Frames;
import haltere.testing.evaluation.HotaScore;
import haltere.testing.evaluation.IdentityScore;
import haltere.testing.evaluation.Match;
import haltere.testing.evaluation.ObjectPoint;
import haltere.testing.evaluation.TrackLatency;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Set;

/**
 * How well tracks follow the objects of a scene. A point is an object at a moment of truth. A track
 * counts at a moment with the row of the first tick at or after it, at most 10 ms later; it is on
 * an object where the scene's {@link Matching} says so. Tracks in ignored regions that are on no
 * object do not count.
 *
 * <p>IDF1 is that of Ristani and others (2016), {@link IdentityScore}; MOTA that of Bernardin and
 * Stiefelhagen (2008), {@link Correspondences}; HOTA that of Luiten and others (2021), {@link
 * HotaScore}, with similarity 0 at twice the tolerance. With one object, IDF1 is 2 m / (points +
 * track moments on it + track moments elsewhere), with m the moments of the track that was on it
 * most.
 *
 * @param objects identities of truth
 * @param points objects at moments
 * @param covered share of the points that a track is on
 * @param tracksOnIt mean number of tracks on an object while there is one
 * @param identities how many different tracks ever were on an object, mean over the objects
 * @param idf1 0 to 1
 * @param elsewhere track moments on no object, for each point
 * @param offCentre mean distance of the nearest track on an object from the middle of its box, in
 *     sides of the box of at least 8 pixels
 * @param mota at most 1
 * @param hota 0 to 1
 * @param switches how often an object got another track than it had last
 * @param latencyS median time from an object's first point to its first track, seconds; NaN without
 * @param accuracy of positions, and of the velocities of tracks of at least 0.5 s
 * @param position errors of position within the stated 95 %, where true velocities are known
 * @param velocity errors of velocity within the stated 95 %, of tracks of at least 0.5 s
 */
public record ObjectScore(
    int objects,
    long points,
    double covered,
    double tracksOnIt,
    double identities,
    double idf1,
    double elsewhere,
    double offCentre,
    double mota,
    double hota,
    long switches,
    double latencyS,
    Accuracy accuracy,
    Within position,
    Within velocity) {
  private static final double MIN_SIDE_PX = 8;
  private static final long SETTLED_US = 500_000;

  /**
   * Errors within an ellipse of 95 % of stated deviations, without correlation of x and y.
   *
   * @param count errors with stated deviations
   * @param inside those within
   */
  public record Within(long count, long inside) {
    private static final double QUANTILE = Gate.probability(0.95).threshold(2);

    /**
     * Both together.
     *
     * @param other other errors
     * @return their sum
     */
    public Within plus(Within other) {
      return new Within(count + other.count, inside + other.inside);
    }

    /**
     * Share of the errors within.
     *
     * @return 0.95 where deviations are true; NaN without errors
     */
    public double share() {
      return (double) inside / count;
    }

    private Within with(double ex, double sdX, double ey, double sdY) {
      double square = ex * ex / (sdX * sdX) + ey * ey / (sdY * sdY);
      return Double.isNaN(square)
          ? this
          : new Within(count + 1, inside + (square < QUANTILE ? 1 : 0));
    }
  }

  /**
   * Computes the score.
   *
   * @param scene its truth
   * @param rows tracks in any order
   * @return the score
   */
  public static ObjectScore of(ObjectScene scene, Collection<TrackRow> rows) {
    return new Sums(scene, TrackTable.byTime(List.copyOf(rows))).score();
  }

  private record Key(long timeUs, int id) {
    Key(ObjectPoint point) {
      this(point.timeUs(), point.id());
    }
  }

  private static final class Sums {
    private final Matching matching;
    private final List<ObjectPoint> truth = new ArrayList<>();
    private final List<ObjectPoint> tracks = new ArrayList<>();
    private final Map<Key, Box> boxes = new HashMap<>();
    private final Map<Key, TrackRow> rowOf = new HashMap<>();
    private final Map<Integer, Set<Integer>> tracksOf = new HashMap<>();
    private final long[] timesUs;
    private long covered;
    private long pairs;
    private long elsewhere;
    private double offCentre;

    Sums(ObjectScene scene, NavigableMap<Long, List<TrackRow>> ticks) {
      matching = scene.matching();
      timesUs = scene.truth().stream().mapToLong(TruthMoment::timeUs).toArray();
      for (TruthMoment moment : scene.truth()) {
        List<TrackRow> judged =
            TrackTable.at(ticks, moment.timeUs()).stream()
                .filter(row -> !moment.ignores(row.xPx(), row.yPx(), matching))
                .toList();
        Set<TrackRow> lonely = new HashSet<>(judged);
        for (TrueObject object : moment.objects()) {
          add(moment.timeUs(), object, judged, lonely);
        }
        elsewhere += lonely.size();
        for (TrackRow row : judged) {
          ObjectPoint point =
              new ObjectPoint(
                  moment.timeUs(), row.id(), row.xPx(), row.yPx(), row.vxPxS(), row.vyPxS());
          tracks.add(point);
          rowOf.put(new Key(point), row);
        }
      }
    }

    private void add(long timeUs, TrueObject object, List<TrackRow> judged, Set<TrackRow> lonely) {
      Box box = object.box();
      ObjectPoint point =
          new ObjectPoint(
              timeUs, object.id(), box.centreX(), box.centreY(), object.vxPxS(), object.vyPxS());
      truth.add(point);
      boxes.put(new Key(point), box);
      Set<Integer> ids = tracksOf.computeIfAbsent(object.id(), id -> new HashSet<>());
      double nearest = Double.POSITIVE_INFINITY;
      for (TrackRow row : judged) {
        if (matching.distance(box, row.xPx(), row.yPx()) <= 1) {
          pairs++;
          ids.add(row.id());
          lonely.remove(row);
          nearest = Math.min(nearest, distanceInSides(box, row));
        }
      }
      if (nearest < Double.POSITIVE_INFINITY) {
        covered++;
        offCentre += nearest;
      }
    }

    private static double distanceInSides(Box box, TrackRow row) {
      return Math.hypot(
          (row.xPx() - box.centreX()) / Math.max(box.width(), MIN_SIDE_PX),
          (row.yPx() - box.centreY()) / Math.max(box.height(), MIN_SIDE_PX));
    }

    ObjectScore score() {
      Frames frames =
          Frames.at(timesUs, truth, tracks)
              .measuredBy(
                  (t, track) -> matching.distance(boxes.get(new Key(t)), track.x(), track.y()));
      Correspondences correspondences = new Correspondences(frames, 1);
      Map<Integer, Long> bornUs = new HashMap<>();
      tracks.forEach(track -> bornUs.merge(track.id(), track.timeUs(), Math::min));
      Within position = new Within(0, 0);
      Within velocity = new Within(0, 0);
      for (Match match : correspondences.matches()) {
        ObjectPoint t = match.truth();
        TrackRow row = rowOf.get(new Key(match.track()));
        if (!Double.isNaN(t.speed())) {
          position = position.with(row.xPx() - t.x(), row.sdXPx(), row.yPx() - t.y(), row.sdYPx());
          if (t.timeUs() - bornUs.get(row.id()) >= SETTLED_US) {
            velocity =
                velocity.with(
                    row.vxPxS() - t.vx(), row.sdVxPxS(), row.vyPxS() - t.vy(), row.sdVyPxS());
          }
        }
      }
      long n = truth.size();
      return new ObjectScore(
          tracksOf.size(),
          n,
          (double) covered / n,
          (double) pairs / Math.max(covered, 1),
          tracksOf.values().stream().mapToInt(Set::size).average().orElse(0),
          IdentityScore.of(frames, 1).idf1(),
          (double) elsewhere / n,
          offCentre / Math.max(covered, 1),
          correspondences.mota(),
          HotaScore.of(frames, 2).hota(),
          correspondences.switches(),
          TrackLatency.of(frames, correspondences).medianUs() * 1e-6,
          Accuracy.of(frames, correspondences, SETTLED_US),
          position,
          velocity);
    }
  }
}
