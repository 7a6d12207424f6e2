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
 * Decodes the events of a recording in order; its state can be saved and restored. {@link
 * DecodingReader} makes a {@link RecordingReader} of it. A format whose events are contiguous only
 * implements a {@link StreamDecoder}, see {@link FileCursor}; others implement a cursor.
 *
 * <p>Thread rule: one thread.
 */
public interface EventCursor extends Closeable {
  /** Reason for the return of {@link #read}. */
  enum Stop {
    /** The packet is full, or a piece of the file is decoded: call again. */
    MORE,
    /**
     * The clock goes back with the next event; it is decoded after {@link
     * EventTimes#acceptRestart()}.
     */
    CLOCK_WENT_BACK,
    /** The end of the events. */
    END
  }

  /** Creates independent cursors. */
  @FunctionalInterface
  interface EventCursors {
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
     * Receives a piece with events.
     *
     * @param state as saved by {@link EventCursor#save} before it; copied
     * @param offset byte offset in the file
     * @param firstUs time of its first event, microseconds
     * @param lastUs time of its last event; if the first of the next piece is earlier, the clock
     *     went back between them
     * @throws IOException if there are too many segments
     */
    void piece(long[] state, long offset, long firstUs, long lastUs) throws IOException;
  }

  /**
   * Visits the pieces of the recording without decoding, if the file has valid positions and times.
   * For a cursor at the start that is not used afterwards.
   *
   * @param visitor receives the pieces; complete only if true is returned
   * @return false if the events must be decoded for it
   * @throws IOException if the file cannot be read
   */
  default boolean visitPieces(PieceVisitor visitor) throws IOException {
    return false;
  }

  /**
   * Number and times of the events as stated by the file, if valid without decoding. For a cursor
   * at the start that is not used afterwards.
   *
   * @return empty if the events must be decoded for it
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
   * Compression of the events.
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
   * Current position.
   *
   * @return byte offset in the file
   */
  long positionBytes();

  /**
   * Number of the stream of events that it reads.
   *
   * @return unique in the recording; 0 if there is only one
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
   * Saves the state.
   *
   * @param state receives {@link #stateLongs()} values
   * @param at index of the first of them
   */
  void save(long[] state, int at);

  /**
   * Restores a saved state, as if all before it had just been read.
   *
   * @param state the values
   * @param at index of the first of them
   * @throws IOException if the file can no longer be read
   */
  void restore(long[] state, int at) throws IOException;

  @Override
  void close() throws IOException;
}
