package haltere.core.playback;

import haltere.core.stream.StreamHandler;

/**
 * A sink that receives the ends of slices. A slice reaches every sink of a {@link Player} in
 * packets of at most some thousand events, or in none where it is empty; all packets since the last
 * call of {@link #sliceEnd} are the slice that the next call ends. Notifications stand between
 * slices; only the {@code DataLost} for a packet at which a filter failed may stand inside one.
 *
 * <p>It also receives run-ups, the events before the target of a jump and those of a repeated
 * moment, so that its picture does not depend on how the moment was reached. Other sinks, such as
 * files, receive events once, as they are played.
 *
 * <p>Thread rule: called on the player's processing thread.
 *
 * @since 0.1
 */
public interface SliceSink extends StreamHandler {
  /**
   * A slice is complete.
   *
   * @param fromUs start on the source's clock in microseconds
   * @param toUs end, which no event of the slice reaches
   */
  void sliceEnd(long fromUs, long toUs);

  /**
   * Memory of the picture of a slice.
   *
   * @param sliceUs length of the slice, microseconds
   * @return microseconds before the slice's end
   */
  default long memoryUs(long sliceUs) {
    return 0;
  }

  /**
   * A run-up begins, before the notification of the jump. Until the next {@link #sliceEnd} there is
   * nothing to show.
   *
   * @param sliceUs length of the slice that it leads to, as far as is known, microseconds
   */
  default void runUpBegins(long sliceUs) {}

  /** The run-up has ended: the slice that it led to comes next. */
  default void runUpEnds() {}

  /** Playback is paused: the last slice is displayed until the next command. */
  default void sliceHeld() {}
}
