package haltere.core.format.internal.decoding;

import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingWriter;
import haltere.core.format.WriteOptions;
import java.nio.file.Path;
import java.util.Optional;

/** A format without a writer. */
public interface ReadOnlyFormat extends RecordingFormat {
  @Override
  default boolean writable() {
    return false;
  }

  @Override
  default Optional<RecordingWriter> create(Path file, WriteOptions options) {
    return Optional.empty();
  }
}
