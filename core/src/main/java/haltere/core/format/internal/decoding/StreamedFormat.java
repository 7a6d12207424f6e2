package haltere.core.format.internal.decoding;

import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingReader;
import java.io.IOException;
import java.nio.file.Path;

/** A format that is read in one pass, from a file or from a stream alike. */
public interface StreamedFormat extends RecordingFormat {
  @Override
  default RecordingReader open(Path file, ReadOptions options) throws IOException {
    return RecordingFile.reading(file, bytes -> openStream(bytes, options));
  }

  @Override
  default boolean isStreamed() {
    return true;
  }

  @Override
  RecordingReader openStream(RecordingFile stream, ReadOptions options) throws IOException;
}
