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
 * @param geometry sensor of the events; its origin is where plain exports count rows from
 * @param overwrite whether an existing file may be replaced
 * @param origin where plain exports count rows from, if not as their source did
 * @param metadata lines for the header of formats that can hold them, by key
 * @param samples what will be written beside events, for formats whose header says so
 * @param stream where a recording of a {@linkplain RecordingFormat#isStreamed() streamed} format
 *     goes instead of to a file
 * @since 0.1
 */
public record WriteOptions(
    SensorGeometry geometry,
    boolean overwrite,
    Optional<Origin> origin,
    Map<String, String> metadata,
    Set<SampleKind> samples,
    Optional<OutputStream> stream) {
  /** Checks and copies. */
  public WriteOptions {
    Objects.requireNonNull(geometry, "geometry");
    Objects.requireNonNull(origin, "origin");
    metadata = Map.copyOf(metadata);
    samples = Set.copyOf(samples);
  }

  /**
   * Options of one who writes events only.
   *
   * @param geometry sensor of the events
   * @param overwrite whether an existing file may be replaced
   * @param origin where plain exports count rows from, if not as their source did
   * @param metadata lines for the header of formats that can hold them, by key
   */
  public WriteOptions(
      SensorGeometry geometry,
      boolean overwrite,
      Optional<Origin> origin,
      Map<String, String> metadata) {
    this(geometry, overwrite, origin, metadata, Set.of());
  }

  /**
   * Options of one who writes to a file.
   *
   * @param geometry sensor of the events
   * @param overwrite whether an existing file may be replaced
   * @param origin where plain exports count rows from, if not as their source did
   * @param metadata lines for the header of formats that can hold them, by key
   * @param samples what will be written beside events
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
   * The same options but for overwriting.
   *
   * @param allowed whether an existing file may be replaced
   * @return new options
   */
  public WriteOptions withOverwrite(boolean allowed) {
    return new WriteOptions(geometry, allowed, origin, metadata, samples, stream);
  }

  /**
   * The same options but for what is written beside events.
   *
   * @param kinds kinds of samples that will be written
   * @return new options
   */
  public WriteOptions withSamples(Set<SampleKind> kinds) {
    return new WriteOptions(geometry, overwrite, origin, metadata, kinds, stream);
  }

  /**
   * These options with a stream to write to.
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
   * @param path where a file goes, or what the stream is called
   * @return an empty file
   * @throws IOException if it cannot be written
   */
  public AtomicFile create(Path path) throws IOException {
    return stream.isPresent()
        ? AtomicFile.on(path, stream.get())
        : AtomicFile.create(path, overwrite);
  }
}
