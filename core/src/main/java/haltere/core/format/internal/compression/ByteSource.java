package haltere.core.format.internal.compression;

import java.io.IOException;

/**
 * Where compressed bytes come from, stretch by stretch.
 *
 * <p>Thread rule: one thread.
 */
public interface ByteSource {
  /**
   * Makes some bytes available in {@link #bytes()}.
   *
   * @param offset where they start; at or behind where the stretch before started
   * @param count how many, few enough for memory
   * @return index of the first, or -1 if there are not so many
   * @throws IOException if they cannot be read
   * @throws DamagedPacketException if what they lie in is damaged
   */
  int require(long offset, int count) throws IOException, DamagedPacketException;

  /**
   * The bytes.
   *
   * @return borrowed array, another one after each {@link #require}
   */
  byte[] bytes();
}
