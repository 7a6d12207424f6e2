package haltere.core.format.internal.csv;

import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.FileHead;
import haltere.core.format.ProbeResult;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Support;
import haltere.core.format.ViolationCounts;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.decoding.ColumnGuess;
import haltere.core.format.internal.decoding.EventCursor;
import haltere.core.format.internal.decoding.FileCursor;
import haltere.core.format.internal.decoding.SensorGuess;
import haltere.core.format.internal.decoding.StreamedFormat;
import haltere.core.format.internal.reader.DecodingReader;
import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Events as text. Written: a header row {@code t_us,x,y,on}, then a row per event, with the origin
 * of rows of the source or the user's options. Read: any columns in any order, see {@link
 * CsvLayout}; rows count from the top by default.
 */
public final class CsvFormat implements StreamedFormat {
  private static final int MAX_SIDE = 1 << 15;

  /** Called by the service loader. */
  public CsvFormat() {}

  @Override
  public String name() {
    return "csv";
  }

  @Override
  public String description() {
    return "events as text, t, x, y and polarity in any order; written as t_us,x,y,on";
  }

  @Override
  public Set<String> extensions() {
    return new LinkedHashSet<>(List.of("csv", "txt"));
  }

  @Override
  public boolean sharesExtensions() {
    return true;
  }

  @Override
  public boolean hasEitherOrigin() {
    return true;
  }

  @Override
  public ProbeResult probe(FileHead head) {
    Optional<CsvLayout> layout = CsvLayout.of(head.head());
    if (layout.isEmpty()) {
      return new ProbeResult(Support.NONE, "it is not text with times, columns and rows");
    }
    if (layout.get().isDoubtful()) {
      return new ProbeResult(
          Support.NONE,
          "it is a table with other columns than those of events, without polarities");
    }
    return layout.get().named()
        ? new ProbeResult(Support.CERTAIN, "it is text and names its columns")
        : new ProbeResult(Support.PLAUSIBLE, "it is text of four numbers a line");
  }

  @Override
  public RecordingReader openStream(RecordingFile file, ReadOptions options) throws IOException {
    CsvLayout layout =
        CsvLayout.of(file.read(0, FileHead.HEAD_BYTES))
            .orElseThrow(
                () ->
                    new RecordingProblem(
                        file.path(),
                        "it is not a text of events: name the columns in a first line, such as "
                            + "t_us,x,y,on, and end each line with a line feed"));
    if (layout.obstacle().isPresent()) {
      throw new RecordingProblem(file.path(), layout.obstacle().get());
    }
    List<String> remarks = new ArrayList<>();
    if (!layout.named()) {
      ColumnGuess.remark(layout.roles()).ifPresent(remarks::add);
    }
    ColumnGuess.remarkOnPolarities(layout.roles()).ifPresent(remarks::add);
    Origin origin = SensorGuess.origin(Optional.empty(), options, remarks);
    SensorGeometry size = size(file, layout, options, remarks);
    SensorGeometry geometry = new SensorGeometry(size.width(), size.height(), origin);
    return new DecodingReader(
        name(),
        file,
        geometry,
        remarks,
        options,
        new ViolationCounts(),
        violations -> cursor(file, layout, geometry, violations));
  }

  private static SensorGeometry size(
      RecordingFile file, CsvLayout layout, ReadOptions options, List<String> remarks)
      throws IOException {
    if (layout.width() > 0) {
      return SensorGuess.top(layout.width(), layout.height());
    }
    if (options.sensor().isPresent()) {
      return options.sensor().get();
    }
    file.requireFile(SensorGuess.ADVICE);
    return SensorGuess.usual(
        sensor -> cursor(file, layout, sensor, new ViolationCounts()), MAX_SIDE, remarks);
  }

  private static EventCursor cursor(
      RecordingFile file, CsvLayout layout, SensorGeometry geometry, ViolationCounts violations) {
    return new FileCursor(
        file,
        layout.dataOffset(),
        ByteOrder.LITTLE_ENDIAN,
        new CsvDecoder(layout, geometry, violations),
        violations);
  }

  @Override
  public Optional<RecordingWriter> create(Path file, WriteOptions options) throws IOException {
    return Optional.of(CsvWriter.create(file, options));
  }
}
