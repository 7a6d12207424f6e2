package haltere.testing.evaluation;

import java.util.List;

/**
 * What there truly is, and what the tracker says there is, at one time.
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
