package haltere.core.format;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import java.io.Closeable;
import java.io.IOException;
import java.util.List;

/**
 * Writes events to a recording. It writes to a hidden temporary file beside the target, which
 * {@link #finish} renames; closing it earlier deletes the temporary file.
 *
 * <p>Thread rule: one thread at a time.
 *
 * @since 0.1
 */
public interface RecordingWriter extends Closeable {
  /**
   * Writes a packet.
   *
   * @param packet borrowed, not modified
   * @throws IOException if it cannot be written
   * @throws IllegalStateException after {@link #finish}
   */
  void write(EventPacket packet) throws IOException;

  /**
   * Flushes buffered data to the file, if the format and the output allow it; otherwise does
   * nothing.
   *
   * @throws IOException if it cannot be written
   */
  default void writeThrough() throws IOException {}

  /**
   * Writes a frame, an inertial sample or a trigger. Samples and packets must be in order of time.
   *
   * @param sample the sample
   * @return false if the format does not store its kind; the sample is then lost
   * @throws IOException if it cannot be written
   * @throws IllegalStateException after {@link #finish}, if the format stores samples
   */
  default boolean write(SensorSample sample) throws IOException {
    return false;
  }

  /**
   * Data that the format could not store so far, such as times beyond its clock.
   *
   * @return one line each, with counts; none unless a format overrides this
   */
  default List<String> losses() {
    return List.of();
  }

  /**
   * Completes the file and renames it to its target.
   *
   * @throws IOException if that fails; the target is then unchanged
   */
  void finish() throws IOException;

  @Override
  void close() throws IOException;
}
