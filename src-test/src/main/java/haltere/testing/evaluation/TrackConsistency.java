package haltere.testing.evaluation;

import haltere.filters.estimation.Consistency;
import haltere.filters.estimation.Gate;
import haltere.filters.estimation.Interval;
import haltere.filters.track.TrackUpdate;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SplittableRandom;

/**
 * Whether tracks on {@link TrackingScene}s are as sure as they say: normalised innovations squared
 * (NIS, two degrees of freedom) and normalised estimation errors squared of place and velocity
 * along an axis (NEES, two degrees of freedom, two axes), of the object that a track is on; see
 * {@link FollowedObjects}.
 *
 * <p>Of a consistent filter 95 % of each are below the 95 % quantile of chi squared: that is what
 * an ellipse of 95 % promises. The errors of one track follow each other, so bands are those of as
 * many values as there are tracks, and are held against one update of each, drawn at random.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 */
public final class TrackConsistency {
  private static final double CONFIDENCE = 0.95;
  private static final int DEGREES = 2;
  private static final long TICK_US = 10_000;

  private final double quantile = Gate.probability(CONFIDENCE).threshold(DEGREES);
  private final SplittableRandom random = new SplittableRandom(1);
  private final Values nis = new Values();
  private final Values nees = new Values();

  /** Nothing seen yet. */
  public TrackConsistency() {
    // the fields are enough
  }

  /**
   * Adds a scene.
   *
   * @param scene with its truth
   * @param rows its tracks at the times of the scene
   * @param updates all steps of these tracks
   */
  public void add(TrackingScene scene, List<ObjectPoint> rows, List<TrackUpdate> updates) {
    Map<Long, ObjectPoint> truth = new HashMap<>();
    scene.truth().forEach(point -> truth.put(key(point.timeUs(), point.id()), point));
    Map<Long, Integer> objectOf = new HashMap<>();
    Frames frames = TrackingScores.frames(scene, rows);
    for (Match match : FollowedObjects.of(frames, TrackingScores.GATE_PX)) {
      objectOf.put(key(match.track().timeUs(), match.track().id()), match.truth().id());
    }
    Map<Integer, List<TrackUpdate>> ofTracks = new HashMap<>();
    updates.forEach(u -> ofTracks.computeIfAbsent(u.id(), id -> new ArrayList<>()).add(u));
    for (List<TrackUpdate> ofTrack : ofTracks.values()) {
      List<double[]> values = new ArrayList<>();
      for (TrackUpdate update : ofTrack) {
        long beforeUs = Math.floorDiv(update.timeUs(), TICK_US) * TICK_US;
        Integer object = objectOf.get(key(beforeUs + TICK_US, update.id()));
        ObjectPoint before = object == null ? null : truth.get(key(beforeUs, object));
        if (before != null) {
          ObjectPoint after = truth.get(key(beforeUs + TICK_US, object));
          values.add(normalised(update, between(before, after, update.timeUs())));
        }
      }
      int one = values.isEmpty() ? -1 : random.nextInt(values.size());
      for (int i = 0; i < values.size(); i++) {
        nis.add(values.get(i)[0], i == one);
        nees.add(values.get(i)[1], i == one);
        nees.add(values.get(i)[2], i == one);
      }
    }
  }

  private static long key(long timeUs, int id) {
    return timeUs * 1000 + id;
  }

  /** NIS, and NEES of both axes. */
  private static double[] normalised(TrackUpdate u, ObjectPoint truth) {
    return new double[] {
      u.nis(),
      square(u.x() - truth.x(), u.vx() - truth.vx(), u.pXx(), u.pXvx(), u.pVxvx()),
      square(u.y() - truth.y(), u.vy() - truth.vy(), u.pYy(), u.pYvy(), u.pVyvy())
    };
  }

  /** eᵀ P⁻¹ e of a place and a velocity. */
  private static double square(double e, double ev, double p, double pv, double pvv) {
    return (pvv * e * e - 2 * pv * e * ev + p * ev * ev) / (p * pvv - pv * pv);
  }

  /** Where an object is between two points of its smooth way: Hermite's cubic. */
  private static ObjectPoint between(ObjectPoint from, ObjectPoint to, long timeUs) {
    double h = (to.timeUs() - from.timeUs()) * 1e-6;
    double u = (timeUs - from.timeUs()) * 1e-6 / h;
    double a = (1 + 2 * u) * (1 - u) * (1 - u);
    double b = u * (1 - u) * (1 - u) * h;
    double c = u * u * (3 - 2 * u);
    double d = u * u * (u - 1) * h;
    double slope = 6 * u * (u - 1) / h;
    double start = (1 - u) * (1 - 3 * u);
    double end = u * (3 * u - 2);
    return new ObjectPoint(
        timeUs,
        from.id(),
        a * from.x() + b * from.vx() + c * to.x() + d * to.vx(),
        a * from.y() + b * from.vy() + c * to.y() + d * to.vy(),
        slope * (from.x() - to.x()) + start * from.vx() + end * to.vx(),
        slope * (from.y() - to.y()) + start * from.vy() + end * to.vy());
  }

  /**
   * Mean NIS of all updates, refused ones among them.
   *
   * @return 2 of a consistent filter
   */
  public double meanNis() {
    return nis.sum / nis.count;
  }

  /**
   * Mean NEES along an axis of all updates.
   *
   * @return 2 of a consistent filter
   */
  public double meanNees() {
    return nees.sum / nees.count;
  }

  /**
   * Where {@link #meanNis} of a consistent filter is with 95 % probability.
   *
   * @return the band of as many values as there are tracks
   */
  public Interval nisBand() {
    return nis.band();
  }

  /**
   * Where {@link #meanNees} of a consistent filter is with 95 % probability.
   *
   * @return the band of as many values as there are axes of tracks
   */
  public Interval neesBand() {
    return nees.band();
  }

  /**
   * Share of innovations within the ellipse of 95 % that was expected of them.
   *
   * @return 0.95 of a consistent filter
   */
  public double nisInside() {
    return (double) nis.inside / nis.count;
  }

  /**
   * Share of errors of place and velocity within the ellipse of 95 % that the track states.
   *
   * @return 0.95 of a consistent filter
   */
  public double neesInside() {
    return (double) nees.inside / nees.count;
  }

  @Override
  public String toString() {
    return "NIS " + nis + "; NEES along an axis " + nees;
  }

  /** Values, and among them one of each track. */
  private final class Values {
    private final List<Double> all = new ArrayList<>();
    private long count;
    private long inside;
    private double sum;
    private int tracks;
    private int tracksInside;

    void add(double value, boolean isOneOfTrack) {
      boolean isInside = value < quantile;
      all.add(value);
      count++;
      inside += isInside ? 1 : 0;
      sum += value;
      if (isOneOfTrack) {
        tracks++;
        tracksInside += isInside ? 1 : 0;
      }
    }

    Interval band() {
      return Consistency.meanBand(DEGREES, tracks, CONFIDENCE);
    }

    @Override
    public String toString() {
      List<Double> sorted = all.stream().sorted().toList();
      Interval band = band();
      double half = 1.96 * Math.sqrt(CONFIDENCE * (1 - CONFIDENCE) / tracks);
      return String.format(
          Locale.ROOT,
          "of %d updates: mean %.2f (band %.2f to %.2f), median %.2f (1.39 expected), within 95 %%"
              + " %.1f %%; of one update each %.1f %% (band %.1f to %.1f %%)",
          count,
          sum / count,
          band.lower(),
          band.upper(),
          sorted.get(sorted.size() / 2),
          100.0 * inside / count,
          100.0 * tracksInside / tracks,
          100 * (CONFIDENCE - half),
          100 * Math.min(1, CONFIDENCE + half));
    }
  }
}
