package haltere.ui.viewer.playback;

import haltere.core.playback.Playable;

/**
 * The seekable part of the elapsed timeline: all of a recording, the buffered interval of a camera
 * or a scene.
 *
 * @param fromUs its start, microseconds
 * @param toUs its end, not included, microseconds
 * @param grows whether it grows during playback
 */
public record SeekableRange(long fromUs, long toUs, boolean grows) {
  /** The range of a playable. */
  public static SeekableRange of(Playable playable) {
    boolean grows = playable.durationUs().isEmpty();
    return new SeekableRange(
        playable.earliestUs(),
        grows ? playable.nearestUs(Long.MAX_VALUE) : playable.durationUs().getAsLong(),
        grows);
  }

  /** Whether the range is empty. */
  public boolean isEmpty() {
    return toUs <= fromUs;
  }
}
