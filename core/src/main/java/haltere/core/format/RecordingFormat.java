package haltere.core.format;

import haltere.core.event.SampleKind;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;

/**
 * A file format. Formats are found as services ({@code
 * META-INF/services/haltere.core.format.RecordingFormat}), so that another jar can add one; see
 * {@link Recordings}.
 *
 * <p>Thread rule: all methods may be called from any thread.
 *
 * @since 0.1
 */
public interface RecordingFormat {
  /**
   * The name by which users select the format.
   *
   * @return lower case, such as {@code aedat2}
   */
  String name();

  /**
   * Description in a few words for users.
   *
   * @return such as "AEDAT-2.0 (jAER)"
   */
  String description();

  /**
   * Usual file name extensions of this format. The first one selects this format for writing.
   *
   * @return lower case, without the dot, in order
   */
  Set<String> extensions();

  /**
   * Whether other kinds of files often have the same extensions, such as text tables. In a folder,
   * only its content identifies such a file as a recording.
   *
   * @return false if the extension alone identifies a recording
   */
  default boolean sharesExtensions() {
    return false;
  }

  /**
   * Assesses by its content whether a file has this format.
   *
   * @param head start and end of the file
   * @return confidence and reason
   */
  ProbeResult probe(FileHead head);

  /**
   * Opens a recording.
   *
   * @param file a file of this format, as detected or as specified by the user
   * @param options the user's options
   * @return a reader at its start
   * @throws IOException a {@link RecordingProblem} if the file is not valid
   */
  RecordingReader open(Path file, ReadOptions options) throws IOException;

  /**
   * Whether recordings of the format are read and written in one pass, so that they may come from
   * standard input and go to standard output.
   *
   * @return true if {@link #openStream} and a writer with {@link WriteOptions#stream()} work
   */
  default boolean isStreamed() {
    return false;
  }

  /**
   * Opens a recording from a stream of bytes.
   *
   * @param stream bytes of this format
   * @param options the user's options
   * @return a reader at its start, which cannot seek
   * @throws IOException a {@link RecordingProblem} if the stream is not valid, or the format cannot
   *     be read in one pass
   */
  default RecordingReader openStream(RecordingFile stream, ReadOptions options) throws IOException {
    throw new RecordingProblem(
        stream.path(), name() + " cannot be read from a stream; save it to a file first");
  }

  /**
   * Whether the format can be written.
   *
   * @return false if {@link #create} always returns empty
   */
  default boolean writable() {
    return true;
  }

  /**
   * Kinds of samples that a writer of the format stores.
   *
   * @return not necessarily all samples of each kind
   */
  default Set<SampleKind> writableSamples() {
    return Set.of();
  }

  /**
   * Whether files of the format may have either origin of rows, see {@link WriteOptions#origin()};
   * other formats define it.
   *
   * @return true for plain tables of events
   */
  default boolean hasEitherOrigin() {
    return false;
  }

  /**
   * Starts a recording.
   *
   * @param file its path
   * @param options of the writer
   * @return a writer, or empty for a format that is only read
   * @throws IOException if the file cannot be written
   */
  Optional<RecordingWriter> create(Path file, WriteOptions options) throws IOException;
}
