package haltere.core.sink;

import java.io.Closeable;
import java.util.Optional;

/**
 * Sends lines to receivers, for example over a network. It never blocks the caller: if there is no
 * room, a line is dropped and counted. The receiver is notified when there is room again, if the
 * transport allows it.
 *
 * <p>Thread rule: lines are sent by one thread; everything else may be called by any.
 *
 * @since 0.1
 */
public interface LineOutput extends Closeable {
  /**
   * Where the lines can be received.
   *
   * @return the address as given, with the chosen port if none was given
   */
  String address();

  /**
   * Sends a line. It does not throw if a receiver fails.
   *
   * @param topic what the line is about, for transports where receivers choose, such as {@code
   *     kalman-tracks/tracks}
   * @param line its bytes with the line feed; not changed by anyone afterwards
   */
  void send(String topic, byte[] line);

  /**
   * Number of connected receivers.
   *
   * @return -1 if the transport does not know
   */
  int receivers();

  /**
   * Lines that were dropped because a receiver had no room for them, or after a {@link #failure()}.
   *
   * @return a count over all receivers, as far as the transport knows
   */
  long lost();

  /**
   * Receivers that were refused because there were too many.
   *
   * @return a count
   */
  default long refused() {
    return 0;
  }

  /**
   * The reason why sending has stopped.
   *
   * @return a few words for users; empty while lines are sent
   */
  default Optional<String> failure() {
    return Optional.empty();
  }

  /** Sends waiting lines, for a second at most, and closes. */
  @Override
  void close();
}
