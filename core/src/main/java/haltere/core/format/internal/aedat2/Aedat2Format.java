package haltere.core.format.internal.aedat2;

import haltere.core.format.FileHead;
import haltere.core.format.ProbeResult;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Support;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.decoding.StreamedFormat;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** AEDAT-2.0, the format of jAER from 2008 until AEDAT-4: read and written. */
public final class Aedat2Format implements StreamedFormat {
  /** Called by the service loader. */
  public Aedat2Format() {}

  @Override
  public String name() {
    return "aedat2";
  }

  @Override
  public String description() {
    return "AEDAT-2.0 (jAER): DVS128 and DAVIS";
  }

  @Override
  public Set<String> extensions() {
    return new LinkedHashSet<>(List.of("aedat", "aedat2"));
  }

  @Override
  public ProbeResult probe(FileHead head) {
    AedatHeader header = Aedat1Format.headerOf(head);
    if (header.version().orElse(-1) == 2) {
      return new ProbeResult(Support.CERTAIN, "its header says AEDAT-" + header.versionText());
    }
    return new ProbeResult(
        Support.NONE,
        header.version().isPresent()
            ? "its header says AEDAT-" + header.versionText()
            : "it has no line #!AER-DAT2.0");
  }

  @Override
  public RecordingReader openStream(RecordingFile bytes, ReadOptions options) throws IOException {
    AedatHeader header = AedatReader.header(bytes);
    List<String> remarks = new ArrayList<>();
    if (header.version().isEmpty()) {
      remarks.add("the line #!AER-DAT2.0 is missing; it is still read as AEDAT-2.0");
    } else if (header.version().getAsInt() != 2) {
      throw new RecordingProblem(
          bytes.path(),
          "the header says AEDAT-" + header.versionText() + ", not 2.0; leave out --format");
    }
    AedatSensor sensor = AedatSensor.of(header, options, bytes);
    remarks.addAll(sensor.remarks());
    return AedatReader.open(
        name(), bytes, header, sensor, remarks, RecordDecoder.AEDAT2_BYTES, options);
  }

  @Override
  public Optional<RecordingWriter> create(Path file, WriteOptions options) throws IOException {
    return Optional.of(Aedat2Writer.create(file, options));
  }
}
