package haltere.core.format.internal.decoding;

import haltere.core.event.EventPacket;
import haltere.core.format.RecordingClock;
import haltere.core.format.internal.clock.EventTimes;
import java.nio.ByteBuffer;

/**
 * Turns bytes of a format into packets, whatever the pieces in which the bytes come: from a file,
 * from the messages of a bag, from a camera. Pure: all state is in the object and can be noted and
 * put back.
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
   * @param in bytes in the format's order; its position is moved behind what was decoded
   * @param offset of that position in the file, for the counts
   * @param out events are appended; its capacity may grow beyond {@code maxEvents}
   * @param maxEvents events that the packet may hold
   * @return true if the clock went back at the input's position: the event there will be decoded,
   *     as the first of a new segment, after {@link EventTimes#acceptRestart()}
   */
  boolean decode(ByteBuffer in, long offset, EventPacket out, int maxEvents);

  /**
   * Decodes what {@link #decode} left of the last bytes of a file, for formats whose last unit has
   * no mark of its end.
   *
   * @param in the last bytes
   * @param offset of its position in the file
   * @param out an event may be appended
   * @param maxEvents events that the packet may hold, more than it holds
   * @return true if these bytes are a whole unit (decoded, unless the clock went back: then it is
   *     decoded at the next call); false if the file is cut off in the middle of it
   */
  default boolean decodeLast(ByteBuffer in, long offset, EventPacket out, int maxEvents) {
    return false;
  }

  /**
   * Whether the bytes that were decoded last belong to a unit that continues.
   *
   * @return true if a file that ends here is cut off
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
   * Notes the state between two calls of {@link #decode}.
   *
   * @param state receives {@link #stateLongs()} values
   * @param at index of the first of them
   */
  default void save(long[] state, int at) {
    times().save(state, at);
  }

  /**
   * Puts a state back.
   *
   * @param state the values
   * @param at index of the first of them
   */
  default void restore(long[] state, int at) {
    times().restore(state, at);
  }
}
