package haltere.core.format.internal.aedat2;

import haltere.core.event.SensorGeometry;
import haltere.core.format.FileHead;
import haltere.core.format.ProbeResult;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.Support;
import haltere.core.format.internal.decoding.ReadOnlyFormat;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * AEDAT-1.0, the oldest recordings of jAER, of DVS128 and Tmpdiff128: read only. A file without a
 * header is detected by the ascending times of its records.
 */
public final class Aedat1Format implements ReadOnlyFormat {
  private static final int CLOCK_RECORDS = 1000;

  /** Called by the service loader. */
  public Aedat1Format() {}

  @Override
  public String name() {
    return "aedat1";
  }

  @Override
  public String description() {
    return "AEDAT-1.0 (jAER before 2008): DVS128";
  }

  @Override
  public Set<String> extensions() {
    return new LinkedHashSet<>(List.of("dat", "aedat"));
  }

  static AedatHeader headerOf(FileHead head) {
    return AedatHeader.parse(head.head(), head.head().length, true).orElseThrow();
  }

  @Override
  public ProbeResult probe(FileHead head) {
    AedatHeader header = headerOf(head);
    if (header.version().orElse(-1) == 1) {
      return new ProbeResult(Support.CERTAIN, "its header says AEDAT-" + header.versionText());
    }
    if (header.version().isPresent()) {
      return new ProbeResult(Support.NONE, "its header says AEDAT-" + header.versionText());
    }
    byte[] bytes = head.head();
    int start = header.dataOffset();
    int records = Math.min(CLOCK_RECORDS, (bytes.length - start) / RecordDecoder.AEDAT1_BYTES);
    if (AedatHeader.clockAscends(
            bytes, start, bytes.length, RecordDecoder.AEDAT1_BYTES, CLOCK_RECORDS)
        && AedatHeader.time(bytes, start, RecordDecoder.AEDAT1_BYTES, records - 1)
                - AedatHeader.time(bytes, start, RecordDecoder.AEDAT1_BYTES, 0)
            > 0) {
      return new ProbeResult(
          Support.PLAUSIBLE, "its bytes have ascending times where AEDAT-1.0 has them");
    }
    return new ProbeResult(
        Support.NONE, "it has no line #!AER-DAT1.0, nor ascending times where that has them");
  }

  @Override
  public RecordingReader open(Path file, ReadOptions options) throws IOException {
    return RecordingFile.reading(file, bytes -> open(bytes, options));
  }

  private RecordingReader open(RecordingFile bytes, ReadOptions options) throws IOException {
    AedatHeader header = AedatReader.header(bytes);
    List<String> remarks = new ArrayList<>();
    if (header.version().isEmpty()) {
      remarks.add("the line #!AER-DAT1.0 is missing; it is read as AEDAT-1.0 of a DVS128");
    } else if (header.version().getAsInt() != 1) {
      throw new RecordingProblem(
          bytes.path(),
          "the header says AEDAT-" + header.versionText() + ", not 1.0; leave out --format");
    }
    SensorGeometry geometry = options.sensor().orElse(AedatSensor.DVS128_SIZE);
    AedatSensor sensor = new AedatSensor(AedatSensor.AddressLayout.DVS128, geometry, remarks);
    return AedatReader.open(
        name(), bytes, header, sensor, remarks, RecordDecoder.AEDAT1_BYTES, options);
  }
}
