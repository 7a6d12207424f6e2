package haltere.core.format.internal.index;

import haltere.core.format.RecordingFile;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.decoding.EventCursor;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Provides the index of a recording: from the file beside it if that is valid, else from one pass
 * over it, which is stored beside it on request.
 */
public final class KeptIndex {
  private final RecordingFile file;
  private final String reading;
  private final boolean keep;
  private final EventCursor.EventCursors cursors;

  /**
   * The index of a recording.
   *
   * @param file the recording
   * @param reading options of reading that an index depends on
   * @param keep whether a new index is stored beside the recording
   * @param cursors decode the events in the pass
   */
  public KeptIndex(
      RecordingFile file, String reading, boolean keep, EventCursor.EventCursors cursors) {
    this.file = file;
    this.reading = reading;
    this.keep = keep;
    this.cursors = cursors;
  }

  /**
   * The index.
   *
   * @param cursor reads the same stream of the recording
   * @param remarks receives notes for users
   * @return the stored one, or a new one
   * @throws IOException if the file cannot be read
   */
  public TimeIndex find(EventCursor cursor, List<String> remarks) throws IOException {
    boolean isBeside = Files.exists(IndexFile.beside(file.path()));
    if (!isBeside && !keep) {
      return scan();
    }
    byte[] identity = IndexFile.identity(file, reading + "|" + cursor.streamNumber());
    if (isBeside) {
      Optional<TimeIndex> stored = besideRecording(identity, cursor.stateLongs(), remarks);
      if (stored.isPresent()) {
        return stored.get();
      }
    }
    TimeIndex built = scan();
    if (keep) {
      keep(built, identity, remarks);
    }
    return built;
  }

  private TimeIndex scan() throws IOException {
    try (EventCursor scanner = cursors.open(new ViolationCounts())) {
      return TimeIndex.scan(file.path(), scanner);
    }
  }

  private Optional<TimeIndex> besideRecording(
      byte[] identity, int stateLongs, List<String> remarks) {
    Path beside = IndexFile.beside(file.path());
    try {
      Optional<TimeIndex> stored = IndexFile.read(file.path(), identity, stateLongs);
      if (stored.isEmpty()) {
        remarks.add(beside + " is out of date and is ignored");
      }
      return stored;
    } catch (IOException e) {
      remarks.add(beside + " cannot be read and is ignored: " + e.getMessage());
      return Optional.empty();
    }
  }

  private void keep(TimeIndex index, byte[] identity, List<String> remarks) {
    try {
      IndexFile.write(file.path(), identity, index);
    } catch (IOException e) {
      remarks.add("the index could not be stored beside the recording: " + e.getMessage());
    }
  }
}
