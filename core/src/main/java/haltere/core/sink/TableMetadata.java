package haltere.core.sink;

import java.io.IOException;
import java.util.Map;

/**
 * Metadata of a table: program, chain and recording. CSV does not store it.
 *
 * @since 0.1
 */
@FunctionalInterface
public interface TableMetadata {
  /** No metadata. */
  TableMetadata NONE = Map::of;

  /**
   * The entries; called once, when the table is finished.
   *
   * @return values by name; the same bytes for the same chain and recording
   * @throws IOException if the recording cannot be read
   */
  Map<String, String> entries() throws IOException;
}
