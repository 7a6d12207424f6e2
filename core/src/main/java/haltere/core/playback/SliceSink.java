package haltere.core.playback;

import haltere.core.stream.StreamHandler;

/**
 * A sink that wants to know where slices end. A slice reaches every sink of a {@link Player} in
 * packets of at most some thousand events, or in none where it is empty; all packets since the last
 * call of {@link #sliceEnd} are the slice that the next call ends. Notifications stand between
 * slices; only the {@code DataLost} for a packet at which a filter failed may stand inside one.
 *
 * <p>Thread rule: called on the player's processing thread.
 */
public interface SliceSink extends StreamHandler {
  /**
   * A slice is complete.
   *
   * @param fromUs start on the source's clock in microseconds
   * @param toUs end, which no event of the slice reaches
   */
  void sliceEnd(long fromUs, long toUs);
}
