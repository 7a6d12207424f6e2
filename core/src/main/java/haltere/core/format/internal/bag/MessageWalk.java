package haltere.core.format.internal.bag;

import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.Payload;
import java.io.Closeable;
import java.io.IOException;

/**
 * Iterates over the messages of a bag, in the order of the file. Damaged ones are counted and
 * skipped.
 *
 * <p>Thread rule: one thread.
 */
interface MessageWalk extends Closeable {
  /** Number of values that {@link #save} writes. */
  int PLACE_LONGS = 2;

  /** Selects the messages at which a walk stops. */
  @FunctionalInterface
  interface Wanted {
    /**
     * Whether a topic's messages are requested.
     *
     * @param topic any
     * @return true to stop at them
     */
    boolean topic(BagTopic topic);
  }

  /**
   * Finds the next message after the one passed last.
   *
   * @return false at the end of the bag
   */
  boolean find() throws IOException;

  /** The topic of the current message. */
  BagTopic topic();

  /** Holds the message: its next {@link #size()} bytes. */
  Payload payload();

  /** Size of the current message in bytes. */
  long size();

  /** Compression of the current message: name of the method, or "none". */
  String compression();

  /** Time of recording, nanoseconds since 1970. */
  long recordedNs();

  /**
   * File offset of a byte of the current message, as if it were uncompressed.
   *
   * @param done bytes of the message before it
   */
  long offset(long done);

  /** Position at which {@link #find} continues. */
  long position();

  /**
   * Skips the rest of the current message.
   *
   * @param unused its number of unused bytes
   */
  void pass(long unused) throws IOException;

  /** Counts damage in the current message, and continues at the next possible one. */
  void damaged(DamagedPacketException damage) throws IOException;

  /**
   * Saves the start of the current message or, without one, the position where {@link #find}
   * continues.
   */
  void save(long[] state, int at);

  /** Restores a saved position: {@link #find} finds the message there. */
  void restore(long[] state, int at) throws IOException;
}
