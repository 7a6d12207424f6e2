package haltere.core.stream;

import haltere.core.event.SensorGeometry;
import java.io.Closeable;
import java.io.IOException;

/**
 * A source of events, pulled one packet, sample or notification at a time. It follows the grammar
 * of {@link StreamNotification}.
 *
 * <p>Thread rule: one thread at a time.
 *
 * @since 0.1
 */
public interface EventSource extends Closeable {
  /**
   * The sensor the events come from.
   *
   * @return the same value at every call
   */
  SensorGeometry geometry();

  /**
   * Passes the next element of the stream to the handler: one packet, one sample or one
   * notification.
   *
   * @param handler receives it
   * @return false, without a call, after {@link EndOfStream}
   * @throws IOException if the source can no longer be read; everything before the damage has been
   *     passed on
   */
  boolean next(StreamHandler handler) throws IOException;

  /**
   * Passes on everything until the end of the stream.
   *
   * @param handler receives it
   * @throws IOException as {@link #next}
   */
  default void drainTo(StreamHandler handler) throws IOException {
    while (next(handler)) {
      if (Thread.currentThread().isInterrupted()) {
        throw new java.io.InterruptedIOException("interrupted while reading " + this);
      }
    }
  }
}
