package haltere.core.sink.internal;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/**
 * Reads and writes from within methods that cannot throw an {@link IOException}: it is thrown as an
 * {@link UncheckedIOException}.
 *
 * <p>Thread rule: that of the reader or writer.
 */
public final class Unchecked {
  /**
   * Reads something.
   *
   * @param <T> type of the result
   */
  @FunctionalInterface
  public interface Reading<T> {
    /** {@return what was read} */
    T read() throws IOException;
  }

  /** Writes something. */
  @FunctionalInterface
  public interface Writing {
    /** Writes it. */
    void write() throws IOException;
  }

  private Unchecked() {}

  /**
   * Reads something.
   *
   * @param reading reads it
   * @param <T> type of the result
   * @return what was read
   */
  public static <T> T read(Reading<T> reading) {
    try {
      return reading.read();
    } catch (IOException problem) {
      throw new UncheckedIOException(problem);
    }
  }

  /**
   * The text of a resource in UTF-8.
   *
   * @param resource closed at its end
   * @return the whole text
   */
  public static String text(InputStream resource) {
    return read(
        () -> {
          try (resource) {
            return new String(resource.readAllBytes(), StandardCharsets.UTF_8);
          }
        });
  }

  /**
   * Writes something.
   *
   * @param writing writes it
   */
  public static void write(Writing writing) {
    try {
      writing.write();
    } catch (IOException problem) {
      throw new UncheckedIOException(problem);
    }
  }
}
