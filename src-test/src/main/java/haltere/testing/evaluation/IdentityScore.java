package haltere.testing.evaluation;

import haltere.filters.estimation.Assignment;

/**
 * How long each object is followed under one identity: IDF1 and its parts.
 *
 * <p>E. Ristani and others (2016), "Performance Measures and a Data Set for Multi-Target,
 * Multi-Camera Tracking", ECCV Workshops. Whole trajectories are matched one to one so that the
 * points on either side that the other does not account for are as few as can be; points count for
 * each other where they are no farther apart than a gate.
 *
 * @param truePoints IDTP, points of matched trajectories within the gate
 * @param falsePoints IDFP, all other points of tracks
 * @param missedPoints IDFN, all other points of truth
 */
public record IdentityScore(long truePoints, long falsePoints, long missedPoints) {
  /**
   * Computes the score.
   *
   * @param frames truth and tracks
   * @param gate the greatest distance of two points that count for each other, finite and positive
   * @return the score
   */
  public static IdentityScore of(Frames frames, double gate) {
    if (!(gate > 0) || Double.isInfinite(gate)) {
      throw new IllegalArgumentException("gate must be positive and finite: " + gate);
    }
    int rows = frames.truthCount();
    int columns = frames.trackCount();
    int[][] common = new int[rows][columns];
    long truthPoints = 0;
    long trackPoints = 0;
    for (Frame frame : frames.list()) {
      truthPoints += frame.truth().size();
      trackPoints += frame.tracks().size();
      for (ObjectPoint truth : frame.truth()) {
        for (ObjectPoint track : frame.tracks()) {
          if (frames.distance(truth, track) <= gate) {
            common[frames.truthIndex(truth)][frames.trackIndex(track)]++;
          }
        }
      }
    }
    // IDFP + IDFN = all points − 2 IDTP, so the fewest errors are the most common points.
    Assignment assignment = new Assignment(rows, columns);
    assignment.start(rows, columns);
    for (int i = 0; i < rows; i++) {
      for (int j = 0; j < columns; j++) {
        assignment.setCost(i, j, -common[i][j]);
      }
    }
    long truePoints = Math.round(-assignment.solve(0, 0));
    return new IdentityScore(truePoints, trackPoints - truePoints, truthPoints - truePoints);
  }

  /**
   * IDF1, the harmonic mean of precision and recall.
   *
   * @return 0 to 1, NaN without any point
   */
  public double idf1() {
    return 2.0 * truePoints / (2 * truePoints + falsePoints + missedPoints);
  }

  /**
   * IDP.
   *
   * @return share of the tracks' points that are right, NaN if they have none
   */
  public double precision() {
    return (double) truePoints / (truePoints + falsePoints);
  }

  /**
   * IDR.
   *
   * @return share of the truth's points that are found, NaN if it has none
   */
  public double recall() {
    return (double) truePoints / (truePoints + missedPoints);
  }
}
