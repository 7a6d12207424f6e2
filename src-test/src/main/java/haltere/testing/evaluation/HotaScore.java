package haltere.testing.evaluation;

import haltere.filters.estimation.Assignment;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * Higher order tracking accuracy of point objects, the mean over 19 thresholds α of 0.05 to 0.95.
 *
 * <p>J. Luiten and others (2021), "HOTA: A Higher Order Metric for Evaluating Multi-Object
 * Tracking", International Journal of Computer Vision 129. The similarity of two points at distance
 * d is S = max(0, 1 − d/d₀). At each α, truth and tracks are matched one to one in each frame where
 * S ≥ α: as many pairs as there can be, among these ways the one whose identities agree most over
 * the whole scene, and among these the nearest (weights 1/ε + A_max + ε S). Then
 *
 * <pre>
 *   DetA = TP / (TP + FN + FP)
 *   AssA = mean over the TP pairs of TPA / (TPA + FNA + FPA)
 *   HOTA = √(DetA · AssA)
 * </pre>
 *
 * <p>The authors' program TrackEval matches once for all α, with weights A_max · S. On random
 * scenes without ambiguity (2 to 8 objects, errors far below their distances) both agree to six
 * digits; where objects are nearer to each other than the errors, HOTA differed by up to 0.002.
 *
 * <p>The score has no meaning without d₀: tracks that are right in all but a constant distance d
 * score ⌊20 S⌋ / 19, at most 1.
 *
 * @param thresholds what was found at each α
 */
public record HotaScore(List<Threshold> thresholds) {
  private static final double EPSILON = 1e-6;
  private static final double ROUNDING = 1e-12;

  /** Copies the list. */
  public HotaScore {
    thresholds = List.copyOf(thresholds);
  }

  /**
   * What was found at one α. Without any point all accuracies are NaN; without a pair AssA is 0 and
   * LocA NaN.
   *
   * @param alpha the least similarity of a pair
   * @param pairs TP, points of truth and track that were matched
   * @param missed FN, points of truth without a track
   * @param falsePoints FP, points of tracks without a truth
   * @param assA association accuracy
   * @param locA mean similarity of the pairs
   */
  public record Threshold(
      double alpha, long pairs, long missed, long falsePoints, double assA, double locA) {
    /**
     * Detection accuracy.
     *
     * @return 0 to 1
     */
    public double detA() {
      return (double) pairs / (pairs + missed + falsePoints);
    }

    /**
     * The score at this α.
     *
     * @return 0 to 1
     */
    public double hota() {
      return Math.sqrt(detA() * assA);
    }
  }

  /**
   * Computes the score.
   *
   * @param frames truth and tracks
   * @param zeroSimilarityDistance d₀, the distance from which on two points have nothing to do with
   *     each other, finite and positive
   * @return the score
   */
  public static HotaScore of(Frames frames, double zeroSimilarityDistance) {
    if (!(zeroSimilarityDistance > 0) || Double.isInfinite(zeroSimilarityDistance)) {
      throw new IllegalArgumentException(
          "the distance of no similarity must be positive and finite: " + zeroSimilarityDistance);
    }
    List<Threshold> thresholds = new ArrayList<>();
    for (int i = 1; i <= 19; i++) {
      thresholds.add(at(i / 20.0, frames, zeroSimilarityDistance));
    }
    return new HotaScore(thresholds);
  }

  /**
   * The score.
   *
   * @return 0 to 1, mean over all α
   */
  public double hota() {
    return mean(Threshold::hota);
  }

  /**
   * Detection accuracy.
   *
   * @return 0 to 1, mean over all α
   */
  public double detA() {
    return mean(Threshold::detA);
  }

  /**
   * Association accuracy.
   *
   * @return 0 to 1, mean over all α
   */
  public double assA() {
    return mean(Threshold::assA);
  }

  private double mean(ToDoubleFunction<Threshold> value) {
    return thresholds.stream().mapToDouble(value).average().orElse(Double.NaN);
  }

  private static Threshold at(double alpha, Frames frames, double d0) {
    double min = alpha - ROUNDING;
    int[] truthPoints = frames.truthPoints();
    int[] trackPoints = frames.trackPoints();
    int[][] possible = new int[truthPoints.length][trackPoints.length];
    for (Frame frame : frames.list()) {
      for (ObjectPoint truth : frame.truth()) {
        for (ObjectPoint track : frame.tracks()) {
          if (similarity(frames, truth, track, d0) >= min) {
            possible[frames.truthIndex(truth)][frames.trackIndex(track)]++;
          }
        }
      }
    }
    int[][] matched = new int[truthPoints.length][trackPoints.length];
    Assignment assignment = new Assignment(frames.mostTruth(), frames.mostTracks());
    long pairs = 0;
    long missed = 0;
    long falsePoints = 0;
    double similarities = 0;
    for (Frame frame : frames.list()) {
      List<ObjectPoint> truth = frame.truth();
      List<ObjectPoint> tracks = frame.tracks();
      assignment.start(truth.size(), tracks.size());
      for (int i = 0; i < truth.size(); i++) {
        int a = frames.truthIndex(truth.get(i));
        for (int j = 0; j < tracks.size(); j++) {
          int b = frames.trackIndex(tracks.get(j));
          double similarity = similarity(frames, truth.get(i), tracks.get(j), d0);
          if (similarity >= min) {
            double agreement = jaccard(possible[a][b], truthPoints[a], trackPoints[b]);
            assignment.setCost(i, j, -(1 / EPSILON + agreement + EPSILON * similarity));
          }
        }
      }
      assignment.solve(0, 0);
      int pairsHere = 0;
      for (int i = 0; i < truth.size(); i++) {
        int j = assignment.columnOf(i);
        if (j != Assignment.NONE) {
          matched[frames.truthIndex(truth.get(i))][frames.trackIndex(tracks.get(j))]++;
          similarities += similarity(frames, truth.get(i), tracks.get(j), d0);
          pairsHere++;
        }
      }
      pairs += pairsHere;
      missed += truth.size() - pairsHere;
      falsePoints += tracks.size() - pairsHere;
    }
    double association = 0;
    for (int a = 0; a < truthPoints.length; a++) {
      for (int b = 0; b < trackPoints.length; b++) {
        association += matched[a][b] * jaccard(matched[a][b], truthPoints[a], trackPoints[b]);
      }
    }
    boolean nothing = pairs + missed + falsePoints == 0;
    double assA = pairs > 0 ? association / pairs : nothing ? Double.NaN : 0;
    double locA = similarities / pairs;
    return new Threshold(alpha, pairs, missed, falsePoints, assA, locA);
  }

  private static double similarity(Frames frames, ObjectPoint truth, ObjectPoint track, double d0) {
    return Math.max(0, 1 - frames.distance(truth, track) / d0);
  }

  /** Common points of two trajectories over the points of either. */
  private static double jaccard(int common, int first, int second) {
    return (double) common / (first + second - common);
  }
}
