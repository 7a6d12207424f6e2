package haltere.core.format.internal.compression;

import java.io.IOException;

/**
 * A source of compressed bytes, section by section.
 *
 * <p>Thread rule: one thread.
 */
public interface ByteSource {
  /**
   * Makes a range of bytes available in {@link #bytes()}.
   *
   * @param offset of the first; not before that of the last call
   * @param count number of bytes, few enough for memory
   * @return index of the first, or -1 if there are fewer
   * @throws IOException if they cannot be read
   * @throws DamagedPacketException if their container is damaged
   */
  int require(long offset, int count) throws IOException, DamagedPacketException;

  /**
   * The bytes.
   *
   * @return borrowed array, replaced by each {@link #require}
   */
  byte[] bytes();
}
