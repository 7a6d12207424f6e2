package haltere.core.sink;

import haltere.core.extension.Extensions;
import java.io.IOException;
import java.util.Map;
import java.util.TreeMap;

/**
 * The available transports, found as services.
 *
 * <p>Thread rule: all methods may be called from any thread.
 *
 * @since 0.1
 */
public final class LineOutputs {
  private LineOutputs() {}

  /**
   * All transports.
   *
   * @return by the scheme of their addresses, in alphabetical order
   */
  public static Map<String, LineOutputProvider> all() {
    Map<String, LineOutputProvider> found = new TreeMap<>();
    for (LineOutputProvider provider : Extensions.find(LineOutputProvider.class)) {
      found.putIfAbsent(provider.scheme(), provider);
    }
    return found;
  }

  /**
   * Checks an address without opening it.
   *
   * @param address such as {@code tcp://127.0.0.1:5555}
   * @return its parts
   * @throws IllegalArgumentException with a line for users if it is invalid, its transport is
   *     missing or cannot use it
   */
  public static LineAddress check(String address) {
    LineAddress parts = LineAddress.parse(address);
    Map<String, LineOutputProvider> all = all();
    LineOutputProvider provider = all.get(parts.scheme());
    if (provider == null) {
      throw new IllegalArgumentException(
          "%s: there is no %s://; there are %s"
              .formatted(address, parts.scheme(), String.join(", ", all.keySet())));
    }
    provider.check(parts);
    return parts;
  }

  /**
   * Opens an output.
   *
   * @param address such as {@code tcp://127.0.0.1:5555}
   * @return an open output
   * @throws IOException with a line for users if it cannot be opened
   * @throws IllegalArgumentException as {@link #check}
   */
  public static LineOutput open(String address) throws IOException {
    LineAddress parts = check(address);
    return all().get(parts.scheme()).open(parts);
  }
}
