package haltere.testing.evaluation;

import haltere.filters.track.Assignment;
import java.util.ArrayList;
import java.util.List;

/**
 * Which object each track is on at a time, whatever identity it had before: the pairs whose places
 * and velocities differ least. Velocities tell apart two objects that pass each other.
 *
 * <p>{@link Correspondences} keep a pair as long as it is within the gate, as identities need it: a
 * track that went on with another object stands for the first one until they are far apart. How
 * sure a track may be of where something is can only be asked of the thing that it is on.
 */
final class FollowedObjects {
  /** What velocities differ by is what they lead to within this time. */
  private static final double AHEAD_S = 0.05;

  private FollowedObjects() {}

  /**
   * Finds them.
   *
   * @param frames truth and tracks, with velocities
   * @param gate the greatest distance of a pair, finite and positive
   * @return all pairs, none of them a switch
   */
  static List<Match> of(Frames frames, double gate) {
    List<Match> found = new ArrayList<>();
    Assignment assignment = new Assignment(frames.mostTruth(), frames.mostTracks());
    for (Frame frame : frames.list()) {
      List<ObjectPoint> truth = frame.truth();
      List<ObjectPoint> tracks = frame.tracks();
      assignment.start(truth.size(), tracks.size());
      double dearest = 0;
      for (int i = 0; i < truth.size(); i++) {
        for (int j = 0; j < tracks.size(); j++) {
          if (truth.get(i).distanceTo(tracks.get(j)) <= gate) {
            double cost = difference(truth.get(i), tracks.get(j));
            dearest = Math.max(dearest, cost);
            assignment.setCost(i, j, cost);
          }
        }
      }
      // One pair more is worth more than any differences that all pairs together could save.
      double worth = dearest * (1 + Math.min(truth.size(), tracks.size())) + 1;
      assignment.solve(worth, worth);
      for (int i = 0; i < truth.size(); i++) {
        if (assignment.columnOf(i) >= 0) {
          found.add(new Match(truth.get(i), tracks.get(assignment.columnOf(i)), false));
        }
      }
    }
    return found;
  }

  private static double difference(ObjectPoint truth, ObjectPoint track) {
    return truth.distanceTo(track)
        + AHEAD_S * Math.hypot(truth.vx() - track.vx(), truth.vy() - track.vy());
  }
}
