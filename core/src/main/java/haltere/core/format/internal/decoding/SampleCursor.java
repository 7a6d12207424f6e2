package haltere.core.format.internal.decoding;

import haltere.core.event.SensorSample;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.reader.DecodingReader;
import java.io.Closeable;
import java.io.IOException;

/**
 * A place in a recording from which frames, inertial samples and triggers are read. It goes through
 * the file by itself, beside the {@link EventCursor} of the same recording, so that reading events
 * alone costs nothing; {@link DecodingReader} puts both in order.
 *
 * <p>Thread rule: one thread.
 */
public interface SampleCursor extends Closeable {
  /** Makes cursors that do not share their places. */
  @FunctionalInterface
  interface Factory {
    /**
     * Opens the recording once more.
     *
     * @param violations where the cursor counts samples that are not whole
     * @return a cursor at the start
     * @throws IOException if the file cannot be read
     */
    SampleCursor open(ViolationCounts violations) throws IOException;
  }

  /** What {@link #next} came to. */
  enum Step {
    /** A sample. */
    SAMPLE,
    /** The place up to which it should look, or some way behind. */
    NOTHING_YET,
    /** The end of the file. */
    END
  }

  /**
   * Advances to the next sample, in the order of the file. It may be far away, so a call searches
   * up to an offset only; the next call continues there.
   *
   * @param untilOffset byte offset in the file
   * @return the result
   * @throws IOException if the file can no longer be read
   */
  Step next(long untilOffset) throws IOException;

  /**
   * The sample to which {@link #next} went.
   *
   * @return a sample
   */
  SensorSample sample();

  /**
   * Where that sample ends.
   *
   * @return byte offset in the file, or of the packet that holds it
   */
  long offset();

  /**
   * Goes to a place that the {@link EventCursor} of the same recording noted. A sample that is only
   * half before the place is left out.
   *
   * @param state the values that it noted
   * @param at index of the first of them
   * @throws IOException if the file can no longer be read
   */
  void restore(long[] state, int at) throws IOException;

  @Override
  void close() throws IOException;
}
