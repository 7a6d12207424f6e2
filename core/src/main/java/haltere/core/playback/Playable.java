package haltere.core.playback;

import haltere.core.event.SensorGeometry;
import haltere.core.stream.EventSource;
import haltere.core.stream.StreamHandler;
import java.io.IOException;
import java.util.OptionalLong;

/**
 * What a {@link Player} plays: a source of events with a timeline that starts at 0 and does not
 * jump, the elapsed time. Where the source's own clock restarts, the stretches are laid end to end.
 *
 * <p>Thread rule: as its source, one thread at a time; {@link #name()}, {@link #geometry()}, {@link
 * #durationUs()} and {@link #seekable()} may be called from any thread.
 *
 * @since 0.1
 */
public interface Playable extends EventSource {
  /**
   * Name for users.
   *
   * @return a file's name or a scene's
   */
  String name();

  @Override
  SensorGeometry geometry();

  /**
   * Length of the elapsed timeline: every event lies before it.
   *
   * @return microseconds, empty where there is no end
   */
  OptionalLong durationUs();

  /**
   * Whether {@link #seek} can reach every position of the timeline. The start can always be
   * reached.
   *
   * @return false if only 0 can be reached
   */
  boolean seekable();

  /**
   * Whether events come at their own time, as from a camera. They are played as they come, at
   * whatever speed.
   *
   * @return false where a player paces them
   */
  default boolean isLive() {
    return false;
  }

  /**
   * Whether there are events to count. Without any, slices by count are cut by time. From any
   * thread.
   *
   * @return false if only samples are played
   */
  default boolean hasEvents() {
    return true;
  }

  /**
   * Earliest position that {@link #seek} can reach at once. From any thread.
   *
   * @return microseconds; 0 where nothing is discarded
   */
  default long earliestUs() {
    return 0;
  }

  /**
   * Limits a position to the range of {@link #seek}. From any thread.
   *
   * @param elapsedUs any position, also before the start and after the end
   * @return the nearest position that {@link #seek} can reach, microseconds
   */
  default long nearestUs(long elapsedUs) {
    return Math.max(0, Math.min(elapsedUs, durationUs().orElse(Long.MAX_VALUE) - 1));
  }

  /**
   * Reads what has come while nothing was read, as far as {@link #seek} can reach it then. Does not
   * wait for more; nothing where events wait for their reader, as in a recording.
   *
   * @throws IOException if it cannot be read
   */
  default void catchUp() throws IOException {
    // a recording or a scene waits
  }

  /**
   * Moves to the first event at or after a position. The next element is a {@code Reset(SEEK)}, or
   * the start of the stream if nothing or the end of the stream was passed on before.
   *
   * @param elapsedUs microseconds, from 0 to before the end
   * @throws IOException if the position cannot be reached
   */
  void seek(long elapsedUs) throws IOException;

  @Override
  boolean next(StreamHandler handler) throws IOException;

  /**
   * Place on the elapsed timeline of a time on the source's clock, in the stretch that the last
   * packet handed over belongs to.
   *
   * @param timeUs time on the source's clock, microseconds
   * @return microseconds since the start
   */
  long elapsedUs(long timeUs);
}
