package haltere.testing.evaluation;

import java.util.List;

/**
 * True and tracked objects at one time.
 *
 * @param timeUs time, microseconds
 * @param truth in the order of their identities, each once
 * @param tracks in the order of their identities, each once
 */
public record Frame(long timeUs, List<ObjectPoint> truth, List<ObjectPoint> tracks) {
  /** Copies the lists. */
  public Frame {
    truth = List.copyOf(truth);
    tracks = List.copyOf(tracks);
  }
}
