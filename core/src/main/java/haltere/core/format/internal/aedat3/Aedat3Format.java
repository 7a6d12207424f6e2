package haltere.core.format.internal.aedat3;

import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.FileHead;
import haltere.core.format.ProbeResult;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.Support;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.decoding.EventCursor;
import haltere.core.format.internal.decoding.FileCursor;
import haltere.core.format.internal.decoding.ReadOnlyFormat;
import haltere.core.format.internal.decoding.SensorGuess;
import haltere.core.format.internal.reader.DecodingReader;
import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** AEDAT-3.0 and AEDAT-3.1, the formats of cAER: read only. */
public final class Aedat3Format implements ReadOnlyFormat {
  private static final int ANY_SIDE = 1 << 15;

  /** Called by the service loader. */
  public Aedat3Format() {}

  @Override
  public String name() {
    return "aedat3";
  }

  @Override
  public String description() {
    return "AEDAT-3.0 and AEDAT-3.1 (cAER)";
  }

  @Override
  public Set<String> extensions() {
    return new LinkedHashSet<>(List.of("aedat3", "aedat"));
  }

  @Override
  public ProbeResult probe(FileHead head) {
    if (!head.startsWith(Aedat3Header.VERSION)) {
      return new ProbeResult(Support.NONE, "it has no line #!AER-DAT3.1");
    }
    Aedat3Header header = Aedat3Header.parse(head.head(), head.head().length >= head.size());
    return new ProbeResult(
        header.isVersion3() ? Support.CERTAIN : Support.NONE,
        "its header says AEDAT-" + header.version());
  }

  @Override
  public RecordingReader open(Path file, ReadOptions options) throws IOException {
    return RecordingFile.reading(file, bytes -> open(bytes, options));
  }

  private RecordingReader open(RecordingFile file, ReadOptions options) throws IOException {
    Aedat3Header header = Aedat3Header.read(file);
    List<String> remarks = new ArrayList<>();
    if (header.version().isEmpty()) {
      remarks.add("the line #!AER-DAT3.1 is missing; it is still read as AEDAT-3.1");
    } else if (!header.isVersion3()) {
      throw new RecordingProblem(
          file.path(), "the header says AEDAT-" + header.version() + ", not 3; leave out --format");
    }
    if (!header.format().isEmpty()) {
      throw new RecordingProblem(
          file.path(),
          "its packets are compressed as "
              + header.format()
              + ", which is not known; record it again as RAW");
    }
    ViolationCounts found = new ViolationCounts();
    if (header.cutOff()) {
      found.add(Violation.CUT_OFF, header.dataOffset());
    }
    SensorGeometry geometry = geometry(file, header, options, remarks);
    return new DecodingReader(
        name(),
        file,
        geometry,
        remarks,
        options,
        found,
        violations -> cursor(file, header, geometry, violations),
        Optional.of(
            violations -> new Aedat3SampleCursor(file, header.dataOffset(), geometry, violations)));
  }

  private static SensorGeometry geometry(
      RecordingFile file, Aedat3Header header, ReadOptions options, List<String> remarks)
      throws IOException {
    Optional<SensorGeometry> stated = header.size().or(options::sensor);
    if (stated.isPresent()) {
      return new SensorGeometry(stated.get().width(), stated.get().height(), Origin.TOP);
    }
    SensorGeometry any = new SensorGeometry(ANY_SIDE, ANY_SIDE);
    try (EventCursor cursor = cursor(file, header, any, new ViolationCounts())) {
      SensorGeometry guess = SensorGuess.of(cursor, Origin.TOP);
      remarks.add(
          "the header does not state the sensor's size; "
              + guess
              + " was taken from the events (--sensor WxH states it)");
      return guess;
    }
  }

  private static EventCursor cursor(
      RecordingFile file, Aedat3Header header, SensorGeometry geometry, ViolationCounts counts) {
    Aedat3Decoder decoder = new Aedat3Decoder(geometry, header.isOldLayout(), file.size(), counts);
    return new FileCursor(file, header.dataOffset(), ByteOrder.LITTLE_ENDIAN, decoder, counts);
  }
}
