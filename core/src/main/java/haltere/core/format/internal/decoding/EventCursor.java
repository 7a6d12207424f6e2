package haltere.core.format.internal.decoding;

import haltere.core.event.EventPacket;
import haltere.core.format.RecordingClock;
import haltere.core.format.RecordingOutline;
import haltere.core.format.RecordingReader;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.clock.EventTimes;
import haltere.core.format.internal.reader.DecodingReader;
import java.io.Closeable;
import java.io.IOException;
import java.util.Map;
import java.util.Optional;

/**
 * A place in a recording from which events are decoded, one after the other, and that can be noted
 * and found again. {@link DecodingReader} makes a whole {@link RecordingReader} of it: a format
 * whose events lie in one run of bytes has only to write a {@link StreamDecoder}, see {@link
 * FileCursor}; others write a cursor.
 *
 * <p>Thread rule: one thread.
 */
public interface EventCursor extends Closeable {
  /** Why {@link #read} came back. */
  enum Stop {
    /** The packet is full, or a piece of the file is done: ask again. */
    MORE,
    /**
     * The clock goes back with the next event; it comes after {@link EventTimes#acceptRestart()}.
     */
    CLOCK_WENT_BACK,
    /** There is nothing more. */
    END
  }

  /** Makes cursors that do not share their places. */
  @FunctionalInterface
  interface Factory {
    /**
     * Opens the recording again.
     *
     * @param violations receives violations of the cursor
     * @return a cursor at the start
     * @throws IOException if the file cannot be read
     */
    EventCursor open(ViolationCounts violations) throws IOException;
  }

  /** Receives the stated pieces of a recording, in order. */
  @FunctionalInterface
  interface PieceVisitor {
    /**
     * Takes a piece with events.
     *
     * @param state what {@link EventCursor#save} would give before it; copied
     * @param offset where it is in the file
     * @param firstUs time of its first event, microseconds
     * @param lastUs time of its last event; if the first of the next piece is below, the clock went
     *     back between them
     * @throws IOException if there are too many segments
     */
    void piece(long[] state, long offset, long firstUs, long lastUs) throws IOException;
  }

  /**
   * Visits the pieces of the recording without decoding, if the file has valid positions and times.
   * For a cursor at the start that is not used afterwards.
   *
   * @param visitor receives the pieces; complete only if true is returned
   * @return false if all must be decoded to know
   * @throws IOException if the file cannot be read
   */
  default boolean visitPieces(PieceVisitor visitor) throws IOException {
    return false;
  }

  /**
   * Number and times of the events as stated by the file, if valid without decoding. For a cursor
   * at the start that is not used afterwards.
   *
   * @return empty if all must be decoded to know
   * @throws IOException if the file cannot be read
   */
  default Optional<RecordingOutline> outline() throws IOException {
    return Optional.empty();
  }

  /**
   * Origin and wrap period of the times.
   *
   * @return the clock of the format
   */
  RecordingClock clock();

  /**
   * Metadata of the recording: camera, its settings and the chain of filters.
   *
   * @return as {@link RecordingReader#metadata()}
   */
  default Map<String, String> metadata() {
    return Map.of();
  }

  /**
   * How the events are compressed.
   *
   * @return as {@link RecordingReader#compression()}
   */
  default Optional<String> compression() {
    return Optional.empty();
  }

  /**
   * Appends events to a packet. Times within the packet do not descend.
   *
   * @param out events are appended
   * @param maxEvents events that the packet may hold
   * @return why no more events were appended
   * @throws IOException if the file can no longer be read
   */
  Stop read(EventPacket out, int maxEvents) throws IOException;

  /**
   * The current time, and the handling of a clock that goes back.
   *
   * @return always the same object, which changes
   */
  EventTimes times();

  /**
   * How far it is.
   *
   * @return byte offset in the file
   */
  long positionBytes();

  /**
   * Which of several streams of events in the recording it reads.
   *
   * @return a number that no other stream of the recording has; 0 where there is one only
   */
  default long streamNumber() {
    return 0;
  }

  /**
   * Number of values that {@link #save} writes.
   *
   * @return at least 1
   */
  int stateLongs();

  /**
   * Notes the place and all that is needed to go on there.
   *
   * @param state receives {@link #stateLongs()} values
   * @param at index of the first of them
   */
  void save(long[] state, int at);

  /**
   * Goes to a place that was noted, as if all before had just been read.
   *
   * @param state the values
   * @param at index of the first of them
   * @throws IOException if the file can no longer be read
   */
  void restore(long[] state, int at) throws IOException;

  @Override
  void close() throws IOException;
}
