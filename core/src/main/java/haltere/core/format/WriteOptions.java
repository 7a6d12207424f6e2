package haltere.core.format;

import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * What a writer needs to know beside the events.
 *
 * @param geometry sensor of the events; its origin is where plain exports count rows from
 * @param overwrite whether an existing file may be replaced
 * @param origin where plain exports count rows from, if not as their source did
 * @param metadata lines for the header of formats that can hold them, by key
 */
public record WriteOptions(
    SensorGeometry geometry,
    boolean overwrite,
    Optional<Origin> origin,
    Map<String, String> metadata) {
  /** Checks and copies. */
  public WriteOptions {
    Objects.requireNonNull(geometry, "geometry");
    Objects.requireNonNull(origin, "origin");
    metadata = Map.copyOf(metadata);
  }

  /**
   * Options for a new file.
   *
   * @param geometry sensor of the events
   * @return no overwriting, the source's origin, no metadata
   */
  public static WriteOptions of(SensorGeometry geometry) {
    return new WriteOptions(geometry, false, Optional.empty(), Map.of());
  }

  /**
   * The same options but for overwriting.
   *
   * @param allowed whether an existing file may be replaced
   * @return new options
   */
  public WriteOptions withOverwrite(boolean allowed) {
    return new WriteOptions(geometry, allowed, origin, metadata);
  }
}
