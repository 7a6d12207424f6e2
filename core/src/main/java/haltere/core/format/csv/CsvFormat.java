package haltere.core.format.csv;

import haltere.core.format.FileHead;
import haltere.core.format.ProbeResult;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Support;
import haltere.core.format.WriteOptions;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;

/**
 * Events as text: a header row {@code t_us,x,y,on}, then a row per event, with the rows counted
 * from the corner that the events' source counts from unless the user says otherwise. Only written.
 */
public final class CsvFormat implements RecordingFormat {
  /** For the service loader. */
  public CsvFormat() {}

  @Override
  public String name() {
    return "csv";
  }

  @Override
  public String description() {
    return "events as text, t_us,x,y,on (written only)";
  }

  @Override
  public Set<String> extensions() {
    return Set.of("csv");
  }

  @Override
  public ProbeResult probe(FileHead head) {
    return new ProbeResult(Support.NONE, "it is only written");
  }

  @Override
  public RecordingReader open(Path file, ReadOptions options) throws IOException {
    throw new RecordingProblem(file, "events as text are written here, not read");
  }

  @Override
  public Optional<RecordingWriter> create(Path file, WriteOptions options) throws IOException {
    return Optional.of(CsvWriter.create(file, options));
  }
}
