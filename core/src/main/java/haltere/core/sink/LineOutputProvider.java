package haltere.core.sink;

import java.io.IOException;

/**
 * A transport for lines, found as a service ({@code
 * META-INF/services/haltere.core.sink.LineOutputProvider}), so that a transport with a library can
 * have a jar of its own.
 *
 * <p>Thread rule: all methods may be called from any thread.
 *
 * @since 0.1
 */
public interface LineOutputProvider {
  /**
   * The scheme of its addresses.
   *
   * @return a word such as {@code tcp}
   */
  String scheme();

  /**
   * Description in one sentence for users.
   *
   * @return ends with a full stop
   */
  String description();

  /**
   * Refuses addresses that this transport cannot use, before any is opened.
   *
   * @param address host and port
   * @throws IllegalArgumentException with a line for users if it cannot be used
   */
  default void check(LineAddress address) {}

  /**
   * Opens an output.
   *
   * @param address host and port
   * @return an open output
   * @throws IOException with a line for users if it cannot be opened
   */
  LineOutput open(LineAddress address) throws IOException;
}
