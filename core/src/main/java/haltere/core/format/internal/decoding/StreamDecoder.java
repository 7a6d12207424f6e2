package haltere.core.format.internal.decoding;

import haltere.core.event.EventPacket;
import haltere.core.format.RecordingClock;
import haltere.core.format.internal.clock.EventTimes;
import java.nio.ByteBuffer;

/**
 * Decodes bytes of a format, in pieces of any size, from a file, the messages of a bag, or a
 * camera. All state is in the object and can be saved and restored.
 *
 * <p>Thread rule: one thread.
 */
public interface StreamDecoder {
  /**
   * Origin and wrap period of the times.
   *
   * @return the clock of the format
   */
  RecordingClock clock();

  /**
   * Decodes until the input has no complete unit, the packet is full, or the clock goes back.
   * Violations are counted, not thrown.
   *
   * @param in bytes in the format's order; its position is advanced past the decoded bytes
   * @param offset of that position in the file, for the counts
   * @param out events are appended; its capacity may grow beyond {@code maxEvents}
   * @param maxEvents events that the packet may hold
   * @return true if the clock went back at the input's position: the event there will be decoded,
   *     as the first of a new segment, after {@link EventTimes#acceptRestart()}
   */
  boolean decode(ByteBuffer in, long offset, EventPacket out, int maxEvents);

  /**
   * Decodes the bytes that {@link #decode} left at the end of a file, for formats whose last unit
   * may be unterminated.
   *
   * @param in the last bytes
   * @param offset of its position in the file
   * @param out an event may be appended
   * @param maxEvents events that the packet may hold, more than it holds
   * @return true if these bytes are a complete unit (decoded or, if the clock went back, decoded at
   *     the next call); false if the file is truncated within it
   */
  default boolean decodeLast(ByteBuffer in, long offset, EventPacket out, int maxEvents) {
    return false;
  }

  /**
   * Whether the bytes decoded last belong to an incomplete unit.
   *
   * @return true if a file that ends here is truncated
   */
  default boolean unfinished() {
    return false;
  }

  /**
   * The current time, and the handling of a clock that goes back.
   *
   * @return always the same object, which changes
   */
  EventTimes times();

  /**
   * Number of values that {@link #save} writes. By default, the state of a decoder is its time.
   *
   * @return at least 1
   */
  default int stateLongs() {
    return times().stateLongs();
  }

  /**
   * Saves the state between two calls of {@link #decode}.
   *
   * @param state receives {@link #stateLongs()} values
   * @param at index of the first of them
   */
  default void save(long[] state, int at) {
    times().save(state, at);
  }

  /**
   * Restores a state.
   *
   * @param state the values
   * @param at index of the first of them
   */
  default void restore(long[] state, int at) {
    times().restore(state, at);
  }
}
