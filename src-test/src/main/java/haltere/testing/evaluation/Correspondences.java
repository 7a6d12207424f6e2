package haltere.testing.evaluation;

import haltere.filters.estimation.Assignment;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Which track stands for which object, frame by frame, and the CLEAR MOT measures that follow.
 *
 * <p>K. Bernardin and R. Stiefelhagen (2008), "Evaluating Multiple Object Tracking Performance: The
 * CLEAR MOT Metrics", EURASIP Journal on Image and Video Processing. In each frame an object first
 * keeps the track that it had last, as long as that is within the gate and no other object has had
 * it since; the others are assigned so that as many as can be have a track, at the least total
 * distance. An object that gets another track than it had last, however long ago, is a switch.
 *
 * <p>The program TrackEval forgets after one frame without a track which track an object had, for
 * keeping it though not for counting switches; on scenes full of noise it may find a switch more.
 */
public final class Correspondences {
  private static final int NONE = -1;

  private final List<Match> matches;
  private final long truthPoints;
  private final long trackPoints;

  /**
   * Finds the correspondences.
   *
   * @param frames truth and tracks
   * @param gate the greatest distance at which a track may stand for an object, finite and positive
   */
  public Correspondences(Frames frames, double gate) {
    if (!(gate > 0) || Double.isInfinite(gate)) {
      throw new IllegalArgumentException("gate must be positive and finite: " + gate);
    }
    List<Match> found = new ArrayList<>();
    int[] lastTrack = new int[frames.truthCount()];
    int[] lastTruth = new int[frames.trackCount()];
    Arrays.fill(lastTrack, NONE);
    Arrays.fill(lastTruth, NONE);
    Assignment assignment = new Assignment(frames.mostTruth(), frames.mostTracks());
    long truthSum = 0;
    long trackSum = 0;
    for (Frame frame : frames.list()) {
      truthSum += frame.truth().size();
      trackSum += frame.tracks().size();
      match(frames, frame, gate, lastTrack, lastTruth, assignment, found);
    }
    matches = List.copyOf(found);
    truthPoints = truthSum;
    trackPoints = trackSum;
  }

  private static void match(
      Frames frames,
      Frame frame,
      double gate,
      int[] lastTrack,
      int[] lastTruth,
      Assignment assignment,
      List<Match> found) {
    List<ObjectPoint> truth = frame.truth();
    List<ObjectPoint> tracks = frame.tracks();
    int[] trackOf = new int[truth.size()];
    Arrays.fill(trackOf, NONE);
    boolean[] taken = new boolean[tracks.size()];
    for (int i = 0; i < truth.size(); i++) {
      int a = frames.truthIndex(truth.get(i));
      for (int j = 0; j < tracks.size(); j++) {
        int b = frames.trackIndex(tracks.get(j));
        if (lastTrack[a] == b
            && lastTruth[b] == a
            && frames.distance(truth.get(i), tracks.get(j)) <= gate) {
          trackOf[i] = j;
          taken[j] = true;
        }
      }
    }
    assignment.start(truth.size(), tracks.size());
    for (int i = 0; i < truth.size(); i++) {
      for (int j = 0; j < tracks.size(); j++) {
        double distance = frames.distance(truth.get(i), tracks.get(j));
        if (trackOf[i] == NONE && !taken[j] && distance <= gate) {
          assignment.setCost(i, j, distance);
        }
      }
    }
    // One pair more is worth more than any distances that all pairs together could save.
    double worth = gate * (1 + Math.min(truth.size(), tracks.size()));
    assignment.solve(worth, worth);
    for (int i = 0; i < truth.size(); i++) {
      int j = trackOf[i] != NONE ? trackOf[i] : assignment.columnOf(i);
      if (j != NONE) {
        int a = frames.truthIndex(truth.get(i));
        int b = frames.trackIndex(tracks.get(j));
        boolean switched = lastTrack[a] != NONE && lastTrack[a] != b;
        found.add(new Match(truth.get(i), tracks.get(j), switched));
        lastTrack[a] = b;
        lastTruth[b] = a;
      }
    }
  }

  /**
   * All pairs.
   *
   * @return in the order of time, then of the objects' identities
   */
  public List<Match> matches() {
    return matches;
  }

  /**
   * Points of truth without a track.
   *
   * @return at least 0
   */
  public long missed() {
    return truthPoints - matches.size();
  }

  /**
   * Points of tracks without an object.
   *
   * @return at least 0
   */
  public long falsePoints() {
    return trackPoints - matches.size();
  }

  /**
   * How often an object got another track than it had last.
   *
   * @return at least 0
   */
  public long switches() {
    return matches.stream().filter(Match::switched).count();
  }

  /**
   * MOTA: 1 − (missed + false + switches) / points of truth.
   *
   * @return at most 1, may be negative; NaN without truth
   */
  public double mota() {
    return truthPoints == 0
        ? Double.NaN
        : 1 - (double) (missed() + falsePoints() + switches()) / truthPoints;
  }

  /**
   * MOTP: the mean distance of the pairs.
   *
   * @return at least 0; NaN without pairs
   */
  public double motp() {
    return matches.stream()
        .mapToDouble(match -> match.truth().distanceTo(match.track()))
        .average()
        .orElse(Double.NaN);
  }
}
