package haltere.core.format.internal.nmnist;

import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.FileHead;
import haltere.core.format.ProbeResult;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingReader;
import haltere.core.format.Support;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.decoding.EventCursor;
import haltere.core.format.internal.decoding.FileCursor;
import haltere.core.format.internal.decoding.ReadOnlyFormat;
import haltere.core.format.internal.decoding.SensorGuess;
import haltere.core.format.internal.reader.DecodingReader;
import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The files of N-MNIST and N-Caltech101: read only. They have no signature; a file is detected by
 * the ascending times of its records.
 */
public final class NmnistFormat implements ReadOnlyFormat {
  /** Minimum number of records for detection, of which 1 % may be out of order. */
  private static final int MIN_RECORDS = 16;

  private static final int PROBE_RECORDS = 4096;
  private static final int MAX_SIDE = 256;

  /** The sizes of the two data sets, and the maximum that the records can address. */
  private static final List<SensorGeometry> SIZES =
      List.of(
          new SensorGeometry(34, 34, Origin.TOP),
          new SensorGeometry(240, 180, Origin.TOP),
          new SensorGeometry(256, 256, Origin.TOP));

  /** Called by the service loader. */
  public NmnistFormat() {}

  @Override
  public String name() {
    return "nmnist";
  }

  @Override
  public String description() {
    return "N-MNIST and N-Caltech101, 5 bytes an event";
  }

  @Override
  public Set<String> extensions() {
    return Set.of("bin");
  }

  @Override
  public boolean sharesExtensions() {
    return true;
  }

  @Override
  public ProbeResult probe(FileHead head) {
    byte[] bytes = head.head();
    int records = Math.min(PROBE_RECORDS, bytes.length / NmnistDecoder.RECORD_BYTES);
    int forth = 0;
    int back = 0;
    long last = 0;
    for (int i = 0; i < records; i++) {
      int at = i * NmnistDecoder.RECORD_BYTES;
      long time =
          (bytes[at + 2] & 0x7fL) << 16 | (bytes[at + 3] & 0xffL) << 8 | bytes[at + 4] & 0xffL;
      forth += time > last ? 1 : 0;
      back += time < last ? 1 : 0;
      last = time;
    }
    boolean ascends = records >= MIN_RECORDS && forth * 2 >= records && back * 100 <= records;
    return new ProbeResult(
        ascends ? Support.PLAUSIBLE : Support.NONE,
        ascends
            ? "its bytes have ascending times where N-MNIST has them"
            : "it has no ascending times where N-MNIST has them");
  }

  @Override
  public RecordingReader open(Path file, ReadOptions options) throws IOException {
    return RecordingFile.reading(file, bytes -> open(bytes, options));
  }

  private RecordingReader open(RecordingFile bytes, ReadOptions options) throws IOException {
    Optional<SensorGeometry> stated =
        options
            .sensor()
            .map(sensor -> new SensorGeometry(sensor.width(), sensor.height(), Origin.TOP));
    SensorGeometry geometry =
        stated.isPresent()
            ? stated.get()
            : SensorGuess.smallest(
                    cursor(bytes, SensorGuess.square(MAX_SIDE), new ViolationCounts()),
                    MAX_SIDE,
                    SIZES)
                .orElse(SIZES.get(0));
    return new DecodingReader(
        name(),
        bytes,
        geometry,
        stated.isPresent() ? List.of() : List.of(SensorGuess.remark(geometry)),
        options,
        new ViolationCounts(),
        violations -> cursor(bytes, geometry, violations));
  }

  private static EventCursor cursor(
      RecordingFile file, SensorGeometry geometry, ViolationCounts violations) {
    return new FileCursor(
        file, 0, ByteOrder.BIG_ENDIAN, new NmnistDecoder(geometry, violations), violations);
  }
}
