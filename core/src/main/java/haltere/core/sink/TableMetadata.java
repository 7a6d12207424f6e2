package haltere.core.sink;

import java.io.IOException;
import java.util.Map;

/**
 * What a table says of itself: program, chain and recording that it was made with. CSV has no place
 * for it.
 *
 * @since 0.1
 */
@FunctionalInterface
public interface TableMetadata {
  /** Says nothing. */
  TableMetadata NONE = Map::of;

  /**
   * The entries, asked for once, when the table is finished.
   *
   * @return values by name; the same bytes for the same chain and recording
   * @throws IOException if the recording cannot be read
   */
  Map<String, String> entries() throws IOException;
}
