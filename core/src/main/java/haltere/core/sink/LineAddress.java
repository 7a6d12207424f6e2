package haltere.core.sink;

import java.util.Objects;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * An address of live results, such as {@code tcp://127.0.0.1:5555}.
 *
 * @param scheme the transport
 * @param host a name or an address, {@code *} for all interfaces, without the brackets of IPv6
 * @param port 0 to 65535; with 0 a listening transport chooses one
 * @since 0.1
 */
public record LineAddress(String scheme, String host, int port) {
  private static final Pattern FORM =
      Pattern.compile("([a-z][a-z0-9+-]*)://(\\[[0-9a-fA-F:.%]+]|[^:/\\[\\]]+):([0-9]{1,5})/?");

  /** Checks the parts. */
  public LineAddress {
    Objects.requireNonNull(scheme, "scheme");
    Objects.requireNonNull(host, "host");
    if (port < 0 || port > 65535) {
      throw new IllegalArgumentException("a port is from 0 to 65535, not " + port);
    }
  }

  /**
   * Reads an address.
   *
   * @param text such as {@code udp://192.168.1.2:5555}
   * @return its parts
   * @throws IllegalArgumentException with a line for users if it is invalid
   */
  public static LineAddress parse(String text) {
    Matcher parts = FORM.matcher(text);
    if (!parts.matches()) {
      throw new IllegalArgumentException(
          text + " is not an address such as tcp://127.0.0.1:5555 (transport, host, port)");
    }
    String host = parts.group(2);
    if (host.startsWith("[")) {
      host = host.substring(1, host.length() - 1);
    }
    return new LineAddress(parts.group(1), host, Integer.parseInt(parts.group(3)));
  }

  /**
   * This address with another port.
   *
   * @param newPort 0 to 65535
   * @return an address
   */
  public LineAddress withPort(int newPort) {
    return new LineAddress(scheme, host, newPort);
  }

  /** The address as text. */
  @Override
  public String toString() {
    return scheme + "://" + (host.indexOf(':') >= 0 ? "[" + host + "]" : host) + ":" + port;
  }
}
