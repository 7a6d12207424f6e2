package haltere.core.format;

import haltere.core.event.Origin;
import haltere.core.event.SampleKind;
import haltere.core.event.SensorGeometry;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * Options of a writer.
 *
 * @param geometry sensor of the events, with the origin of rows in plain exports
 * @param overwrite whether an existing file may be replaced
 * @param origin origin of rows in plain exports, if it differs from that of the geometry
 * @param metadata metadata for the header, by key, if the format has metadata
 * @param samples kinds of samples that will be written, for formats whose header lists them
 * @param stream output of a recording of a {@linkplain RecordingFormat#isStreamed() streamed}
 *     format, instead of a file
 * @since 0.1
 */
public record WriteOptions(
    SensorGeometry geometry,
    boolean overwrite,
    Optional<Origin> origin,
    Map<String, String> metadata,
    Set<SampleKind> samples,
    Optional<OutputStream> stream) {
  /** Checks the values and copies the metadata. */
  public WriteOptions {
    Objects.requireNonNull(geometry, "geometry");
    Objects.requireNonNull(origin, "origin");
    metadata = Map.copyOf(metadata);
    samples = Set.copyOf(samples);
  }

  /**
   * Options for events only.
   *
   * @param geometry sensor of the events
   * @param overwrite whether an existing file may be replaced
   * @param origin origin of rows in plain exports, if it differs from that of the geometry
   * @param metadata metadata for the header, by key, if the format has metadata
   */
  public WriteOptions(
      SensorGeometry geometry,
      boolean overwrite,
      Optional<Origin> origin,
      Map<String, String> metadata) {
    this(geometry, overwrite, origin, metadata, Set.of());
  }

  /**
   * Options for a file.
   *
   * @param geometry sensor of the events
   * @param overwrite whether an existing file may be replaced
   * @param origin origin of rows in plain exports, if it differs from that of the geometry
   * @param metadata metadata for the header, by key, if the format has metadata
   * @param samples kinds of samples that will be written
   */
  public WriteOptions(
      SensorGeometry geometry,
      boolean overwrite,
      Optional<Origin> origin,
      Map<String, String> metadata,
      Set<SampleKind> samples) {
    this(geometry, overwrite, origin, metadata, samples, Optional.empty());
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
   * The same options with or without overwriting.
   *
   * @param allowed whether an existing file may be replaced
   * @return new options
   */
  public WriteOptions withOverwrite(boolean allowed) {
    return new WriteOptions(geometry, allowed, origin, metadata, samples, stream);
  }

  /**
   * The same options with other kinds of samples.
   *
   * @param kinds kinds of samples that will be written
   * @return new options
   */
  public WriteOptions withSamples(Set<SampleKind> kinds) {
    return new WriteOptions(geometry, overwrite, origin, metadata, kinds, stream);
  }

  /**
   * The same options with an output stream.
   *
   * @param target flushed at the end, never closed
   * @return new options
   */
  public WriteOptions withStream(OutputStream target) {
    return new WriteOptions(geometry, overwrite, origin, metadata, samples, Optional.of(target));
  }

  /**
   * Starts the output.
   *
   * @param path the file, or the name of the stream for messages
   * @return an empty file
   * @throws IOException if it cannot be written
   */
  public AtomicFile create(Path path) throws IOException {
    return stream.isPresent()
        ? AtomicFile.on(path, stream.get())
        : AtomicFile.create(path, overwrite);
  }
}
