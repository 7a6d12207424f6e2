package haltere.core.format.internal.decoding;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/**
 * The lines of a header in printable ASCII: a control character becomes a space, any other
 * character a question mark.
 *
 * <p>Thread rule: one thread.
 */
public final class HeaderText {
  private final String lineStart;
  private final String lineEnd;
  private final StringBuilder text = new StringBuilder();

  /**
   * A header without lines.
   *
   * @param lineStart prefix of each line
   * @param lineEnd terminator of each line
   */
  public HeaderText(String lineStart, String lineEnd) {
    this.lineStart = lineStart;
    this.lineEnd = lineEnd;
  }

  /**
   * Adds a line.
   *
   * @param line without its start and end
   */
  public void line(String line) {
    text.append(lineStart);
    line.chars().forEach(c -> text.append(c < ' ' ? ' ' : c > '~' ? '?' : (char) c));
    text.append(lineEnd);
  }

  /**
   * All lines.
   *
   * @return a new buffer, at its start
   */
  public ByteBuffer bytes() {
    return ByteBuffer.wrap(text.toString().getBytes(StandardCharsets.US_ASCII));
  }
}
