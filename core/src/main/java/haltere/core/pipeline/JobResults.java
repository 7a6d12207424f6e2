package haltere.core.pipeline;

import haltere.core.stream.StreamHandler;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/**
 * Results of one recording that go to files: opened before the first packet, finished after the
 * last one, closed in any case. Files appear when they are finished; closed before that, they leave
 * nothing.
 *
 * <p>Thread rule: the processing thread.
 *
 * @since 0.1
 */
public interface JobResults extends Closeable {
  /**
   * A file that was written.
   *
   * @param path where it is
   * @param rows its rows, or its events
   */
  record ResultFile(Path path, long rows) {}

  /**
   * Sinks before the chain.
   *
   * @return sinks that see all packets, samples and notifications and change no packet
   */
  default List<StreamHandler> rawSinks() {
    return List.of();
  }

  /**
   * Sinks after the chain.
   *
   * @return sinks that see all packets, samples and notifications
   */
  default List<StreamHandler> sinks() {
    return List.of();
  }

  /**
   * Completes all files, which then appear.
   *
   * @throws IOException if one cannot be written
   */
  void finish() throws IOException;

  /**
   * The files.
   *
   * @return in the order of the chain, complete once they are finished; none where results are
   *     counted elsewhere
   */
  default List<ResultFile> files() {
    return List.of();
  }

  /** Closes files and sockets, if there are any. */
  @Override
  default void close() throws IOException {}

  /** Opens results. */
  interface Opener {
    /**
     * Opens results.
     *
     * @return open
     * @throws IOException if a file cannot be written
     */
    JobResults open() throws IOException;
  }

  /**
   * Several results as one, finished in this order.
   *
   * @param openers each opens one; those that are open are closed if a later one throws
   * @return open
   * @throws IOException if one cannot be opened
   */
  static JobResults all(Opener... openers) throws IOException {
    return JoinedResults.open(openers);
  }
}
