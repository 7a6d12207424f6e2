package haltere.core.format.internal.npz;

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
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * NumPy: arrays t, x, y, p in a {@code .npz}, or one structured array with such fields or a table
 * of such columns, alone or in a {@code .npz}; written as four arrays.
 */
public final class NpzFormat implements RecordingFormat {
  private static final int MAX_SIDE = 1 << 15;

  /** Called by the service loader. */
  public NpzFormat() {}

  @Override
  public String name() {
    return "npz";
  }

  @Override
  public String description() {
    return "NumPy arrays t, x, y, p, a structured one, or a table (.npz, .npy)";
  }

  @Override
  public Set<String> extensions() {
    return new LinkedHashSet<>(List.of("npz", "npy"));
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
    if (head.startsWith("\u0093NUMPY")) {
      return new ProbeResult(Support.CERTAIN, "it begins as a NumPy array");
    }
    String start =
        new String(head.head(), 0, Math.min(300, head.head().length), StandardCharsets.ISO_8859_1);
    return start.startsWith("PK\3\4") && start.contains(".npy")
        ? new ProbeResult(Support.CERTAIN, "it is a zip file of NumPy arrays")
        : new ProbeResult(Support.NONE, "it begins neither as a NumPy array nor as a zip of them");
  }

  @Override
  public RecordingReader open(Path file, ReadOptions options) throws IOException {
    return RecordingFile.reading(file, bytes -> open(bytes, options));
  }

  private RecordingReader open(RecordingFile file, ReadOptions options) throws IOException {
    NpzLayout layout = NpzLayout.of(file, options.topic());
    List<String> remarks = new ArrayList<>();
    ViolationCounts found = new ViolationCounts();
    if (layout.inconsistent()) {
      found.add(Violation.IMPOSSIBLE_LENGTH, 0);
    }
    if (layout.cutOff()) {
      found.add(Violation.CUT_OFF, file.size());
    }
    Topics.remark(layout.topics()).ifPresent(remarks::add);
    ColumnGuess.remark(layout.guessed()).ifPresent(remarks::add);
    ColumnGuess.remarkOnPolarities(layout.columns().keySet()).ifPresent(remarks::add);
    SensorGeometry geometry;
    Origin origin = SensorGuess.origin(layout.origin(), options, remarks);
    if (layout.sensor().isPresent()) {
      geometry = layout.sensor().get();
    } else {
      geometry =
          options
              .sensor()
              .map(given -> SensorGuess.top(given.width(), given.height()))
              .orElse(null);
      if (geometry == null) {
        geometry =
            SensorGuess.usual(
                any -> new NpzCursor(layout, file, any, new ViolationCounts()), MAX_SIDE, remarks);
      }
    }
    SensorGeometry sensor = new SensorGeometry(geometry.width(), geometry.height(), origin);
    return new DecodingReader(
        name(),
        file,
        sensor,
        remarks,
        options,
        found,
        violations -> new NpzCursor(layout, file, sensor, violations));
  }

  @Override
  public Optional<RecordingWriter> create(Path file, WriteOptions options) throws IOException {
    return Optional.of(new NpzWriter(file, options));
  }
}
