package haltere.core.format.internal.bag;

import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.Payload;
import java.io.Closeable;
import java.io.IOException;

/**
 * Goes from message to message of a bag, in the order of the file. What is damaged is counted and
 * passed over.
 *
 * <p>Thread rule: one thread.
 */
interface MessageWalk extends Closeable {
  /** Numbers that {@link #save} notes. */
  int PLACE_LONGS = 2;

  /** Which messages a walk stops at. */
  @FunctionalInterface
  interface Wanted {
    /**
     * Whether a topic's messages are wanted.
     *
     * @param topic any
     * @return true to stop at them
     */
    boolean topic(BagTopic topic);
  }

  /**
   * Finds the next message, from where the last one was passed.
   *
   * @return false at the end of the bag
   */
  boolean find() throws IOException;

  /** The topic of the message that was found. */
  BagTopic topic();

  /** Holds the message: its next {@link #size()} bytes. */
  Payload payload();

  /** Bytes of the message that was found. */
  long size();

  /** How the message that was found is compressed: name of the method, or "none". */
  String compression();

  /** When it was recorded, nanoseconds since 1970. */
  long recordedNs();

  /**
   * Where a byte of the message that was found is in the file, or would be if it were not
   * compressed.
   *
   * @param done bytes of the message before it
   */
  long offset(long done);

  /** Where {@link #find} continues. */
  long position();

  /**
   * Passes over the rest of the message that was found.
   *
   * @param unused its bytes that were not used
   */
  void pass(long unused) throws IOException;

  /** Counts damage in the message that was found, and continues where the next one may be. */
  void damaged(DamagedPacketException damage) throws IOException;

  /** Notes where the message that was found starts; without one, where {@link #find} continues. */
  void save(long[] state, int at);

  /** Goes to a place that was noted: {@link #find} finds the message there. */
  void restore(long[] state, int at) throws IOException;
}
