package haltere.core.format.internal.hdf5;

import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.FileHead;
import haltere.core.format.ProbeResult;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Support;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.decoding.ColumnGuess;
import haltere.core.format.internal.decoding.SensorGuess;
import haltere.core.format.internal.decoding.Topics;
import haltere.core.format.internal.reader.DecodingReader;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** HDF5: events in the layouts of DSEC, Prophesee and other programs; written in DSEC's. */
public final class Hdf5Format implements RecordingFormat {
  private static final int MAX_SIDE = 1 << 15;

  /** Called by the service loader. */
  public Hdf5Format() {}

  @Override
  public String name() {
    return "hdf5";
  }

  @Override
  public String description() {
    return "HDF5 in the layouts of DSEC and Prophesee";
  }

  @Override
  public Set<String> extensions() {
    return new LinkedHashSet<>(List.of("h5", "hdf5", "hdf"));
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
    for (int at = 0; at < head.head().length; at = at == 0 ? 512 : 2 * at) {
      if (ContainerFile.isSignature(head.head(), at)) {
        return new ProbeResult(Support.CERTAIN, "it starts with the signature of HDF5");
      }
    }
    return new ProbeResult(Support.NONE, "it does not start with the signature of HDF5");
  }

  @Override
  public RecordingReader open(Path file, ReadOptions options) throws IOException {
    return RecordingFile.reading(file, bytes -> open(bytes, options));
  }

  private RecordingReader open(RecordingFile file, ReadOptions options) throws IOException {
    EventTable table = EventTable.of(file, options.topic());
    List<String> remarks = new ArrayList<>();
    Topics.remark(table.topics()).ifPresent(remarks::add);
    ColumnGuess.remark(table.guessed()).ifPresent(remarks::add);
    ColumnGuess.remarkOnPolarities(table.columns().keySet()).ifPresent(remarks::add);
    Origin origin = SensorGuess.origin(table.origin(), options, remarks);
    ViolationCounts found = new ViolationCounts();
    if (table.inconsistent()) {
      found.add(Violation.IMPOSSIBLE_LENGTH, 0);
    }
    if (table.container().isCutOff()) {
      found.add(Violation.CUT_OFF, file.size());
    }
    table
        .triggers()
        .ifPresent(
            triggers -> found.add(Violation.OTHER_DATA, 0, Math.min(triggers.rows(), file.size())));
    SensorGeometry geometry = table.sensor().or(options::sensor).orElse(null);
    if (geometry == null) {
      geometry =
          SensorGuess.usual(
              any -> new Hdf5Cursor(table, any, new ViolationCounts()), MAX_SIDE, remarks);
    }
    SensorGeometry sensor = new SensorGeometry(geometry.width(), geometry.height(), origin);
    return new DecodingReader(
        name(),
        file,
        sensor,
        remarks,
        options,
        found,
        violations -> new Hdf5Cursor(table, sensor, violations),
        table
            .triggers()
            .map(
                triggers ->
                    counted -> new Hdf5TriggerCursor(table.container(), triggers, counted)));
  }

  @Override
  public Optional<RecordingWriter> create(Path file, WriteOptions options) throws IOException {
    return Optional.of(Hdf5Writer.create(file, options, Hdf5Writer.DEFAULT_LEVEL));
  }
}
