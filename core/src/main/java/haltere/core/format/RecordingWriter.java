package haltere.core.format;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import java.io.Closeable;
import java.io.IOException;
import java.util.List;

/**
 * Writes events to a recording. It writes to a hidden file beside the target and moves it there
 * when it is {@link #finish() finished}; closed before that, it leaves nothing.
 *
 * <p>Thread rule: one thread at a time.
 *
 * @since 0.1
 */
public interface RecordingWriter extends Closeable {
  /**
   * Writes a packet.
   *
   * @param packet borrowed and not changed
   * @throws IOException if it cannot be written
   */
  void write(EventPacket packet) throws IOException;

  /**
   * Flushes buffered data to the file, if the format and the way of writing allow; others do
   * nothing.
   *
   * @throws IOException if it cannot be written
   */
  default void writeThrough() throws IOException {}

  /**
   * Writes a frame, an inertial sample or a trigger. It comes in order of time among the packets.
   *
   * @param sample what to write
   * @return false if the format holds nothing of the kind, so that it is lost
   * @throws IOException if it cannot be written
   */
  default boolean write(SensorSample sample) throws IOException {
    return false;
  }

  /**
   * What the format could not hold so far, such as times beyond its clock.
   *
   * @return one line each, with counts
   */
  List<String> losses();

  /**
   * Completes the file and puts it in its place.
   *
   * @throws IOException if that fails; the target is then as it was
   */
  void finish() throws IOException;

  @Override
  void close() throws IOException;
}
