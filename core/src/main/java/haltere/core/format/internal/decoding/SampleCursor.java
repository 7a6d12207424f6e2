package haltere.core.format.internal.decoding;

import haltere.core.event.SensorSample;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.reader.DecodingReader;
import java.io.Closeable;
import java.io.IOException;
import java.util.Optional;

/**
 * Reads the frames, inertial samples and triggers of a recording. It is independent of the {@link
 * EventCursor} of the same recording, so that reading only events has no overhead; {@link
 * DecodingReader} merges both in order of time.
 *
 * <p>Thread rule: one thread.
 */
public interface SampleCursor extends Closeable {
  /** Creates independent cursors. */
  @FunctionalInterface
  interface SampleCursors {
    /**
     * Opens the recording again.
     *
     * @param violations counts incomplete samples
     * @return a cursor at the start
     * @throws IOException if the file cannot be read
     */
    SampleCursor open(ViolationCounts violations) throws IOException;
  }

  /** Result of {@link #next}. */
  enum SampleStep {
    /** A sample. */
    SAMPLE,
    /** No sample up to the requested offset, or somewhat after it. */
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
  SampleStep next(long untilOffset) throws IOException;

  /**
   * The sample found by {@link #next}.
   *
   * @return a sample
   */
  SensorSample sample();

  /**
   * End of that sample.
   *
   * @return byte offset in the file, or of the packet that holds it
   */
  long offset();

  /**
   * A remark on the samples that were read, such as the assumed range of an inertial sensor.
   *
   * @return one line, if there is one so far
   */
  default Optional<String> remark() {
    return Optional.empty();
  }

  /**
   * Goes to a position saved by the {@link EventCursor} of the same recording. A sample that is
   * partly before the position is skipped.
   *
   * @param state the values that it noted
   * @param at index of the first of them
   * @throws IOException if the file can no longer be read
   */
  void restore(long[] state, int at) throws IOException;

  @Override
  void close() throws IOException;
}
