package haltere.ui.viewer.playback;

import haltere.core.playback.Playable;

/**
 * The part of the elapsed timeline that one can go to: all of a recording, the moments that are
 * kept of a camera or a scene.
 *
 * @param fromUs its start, microseconds
 * @param toUs its end, not included, microseconds
 * @param grows whether more comes
 */
public record Reach(long fromUs, long toUs, boolean grows) {
  /** Of what is played now. */
  public static Reach of(Playable playable) {
    boolean grows = playable.durationUs().isEmpty();
    return new Reach(
        playable.earliestUs(),
        grows ? playable.nearestUs(Long.MAX_VALUE) : playable.durationUs().getAsLong(),
        grows);
  }

  /** Whether there is anything. */
  public boolean isEmpty() {
    return toUs <= fromUs;
  }
}
