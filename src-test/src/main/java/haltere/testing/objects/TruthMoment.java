package haltere.testing.objects;

import java.util.List;

/**
 * The truth at one time.
 *
 * @param timeUs on the clock of the events, microseconds
 * @param objects those that a tracker has to show, each identity once
 * @param ignored where tracks are neither right nor wrong: objects hidden by half or more, at the
 *     border or at rest, and regions where nobody can tell
 */
public record TruthMoment(long timeUs, List<TrueObject> objects, List<Box> ignored) {
  /** Copies the lists. */
  public TruthMoment {
    objects = List.copyOf(objects);
    ignored = List.copyOf(ignored);
  }

  /**
   * Whether a track is not to be judged: in an ignored region and near no object.
   *
   * @param x column of the track, pixels
   * @param y row of the track, pixels
   * @param matching distance of tracks and objects
   * @return true if it is left out of all scores
   */
  boolean ignores(double x, double y, Matching matching) {
    return ignored.stream().anyMatch(box -> box.contains(x, y, 0))
        && objects.stream().noneMatch(object -> matching.distance(object.box(), x, y) <= 1);
  }
}
