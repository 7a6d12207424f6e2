package haltere.core.format;

import haltere.core.event.SampleKind;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;

/**
 * A file format. Formats are found as services ({@code
 * META-INF/services/haltere.core.format.RecordingFormat}), so another jar can add one; see {@link
 * Recordings}.
 *
 * <p>Thread rule: all methods may be called from any thread.
 *
 * @since 0.1
 */
public interface RecordingFormat {
  /**
   * The name by which a user can ask for the format.
   *
   * @return lower case, such as {@code aedat2}
   */
  String name();

  /**
   * What the format is, in a few words for users.
   *
   * @return such as "AEDAT-2.0 (jAER)"
   */
  String description();

  /**
   * Endings of names that files of this format usually have. The first one is what a writer of this
   * format answers to.
   *
   * @return lower case, without the dot, in order
   */
  Set<String> extensions();

  /**
   * Whether other kinds of files often have the same endings, such as tables of text. In a folder,
   * such a file is a recording only by its content.
   *
   * @return false if the ending alone makes a recording of a file
   */
  default boolean sharesExtensions() {
    return false;
  }

  /**
   * Says whether a file is of this format, by its content.
   *
   * @param head start and end of the file
   * @return how sure and why
   */
  ProbeResult probe(FileHead head);

  /**
   * Opens a recording.
   *
   * @param file a file that is, or is said to be, of this format
   * @param options of the user
   * @return a reader at its start
   * @throws IOException a {@link RecordingProblem} where the file is not what it should be
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
   * Opens a recording that comes as a stream of bytes.
   *
   * @param stream of this format
   * @param options of the user
   * @return a reader at its start, which cannot seek
   * @throws IOException a {@link RecordingProblem} where the stream is not what it should be, or
   *     the format cannot be read in one pass
   */
  default RecordingReader openStream(RecordingFile stream, ReadOptions options) throws IOException {
    throw new RecordingProblem(
        stream.path(), name() + " cannot be read from a stream; save it to a file first");
  }

  /**
   * Whether the format can be written.
   *
   * @return false if {@link #create} always answers empty
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
   * Starts to write a recording.
   *
   * @param file where it will be
   * @param options about the events
   * @return a writer, or empty for a format that is only read
   * @throws IOException if the file cannot be written
   */
  Optional<RecordingWriter> create(Path file, WriteOptions options) throws IOException;
}
