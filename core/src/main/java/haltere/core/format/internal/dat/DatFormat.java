package haltere.core.format.internal.dat;

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
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.decoding.EventCursor;
import haltere.core.format.internal.decoding.FileCursor;
import haltere.core.format.internal.decoding.SensorGuess;
import haltere.core.format.internal.decoding.StreamedFormat;
import haltere.core.format.internal.evt.PropheseeHeader;
import haltere.core.format.internal.evt.PropheseeSensor;
import haltere.core.format.internal.reader.DecodingReader;
import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Prophesee DAT, decoded events of the kinds 2D and CD: read and written. */
public final class DatFormat implements StreamedFormat {
  /** Maximum columns and rows of a record. */
  static final int MAX_SIDE = 1 << 14;

  static final int CD = 0x0c;
  private static final int EVENT_2D = 0x00;

  /** Key of Haltere's header line: start time of the first clock period. */
  static final String TIME_BASE = "haltere_time_base_us";

  static final long MAX_BASE_US = 1L << 61;

  /** Sizes of sensors; files without a size are from the first sensors. */
  private static final List<SensorGeometry> SIZES =
      List.of(
          new SensorGeometry(304, 240, Origin.TOP),
          new SensorGeometry(640, 480, Origin.TOP),
          new SensorGeometry(1280, 720, Origin.TOP));

  /** Called by the service loader. */
  public DatFormat() {}

  @Override
  public String name() {
    return "dat";
  }

  @Override
  public String description() {
    return "Prophesee DAT, 2D and CD events";
  }

  @Override
  public Set<String> extensions() {
    return Set.of("dat");
  }

  @Override
  public ProbeResult probe(FileHead head) {
    PropheseeHeader header = PropheseeHeader.parse(head.head(), head.head().length >= head.size());
    int data = header.dataOffset();
    if (data == 0 || header.value("version").isEmpty() && header.value("width").isEmpty()) {
      return new ProbeResult(Support.NONE, "it has no header lines of a DAT file");
    }
    if (data + 2 > head.head().length) {
      return new ProbeResult(Support.PLAUSIBLE, "its header could be that of a DAT file");
    }
    if (head.head()[data + 1] != DatDecoder.RECORD_BYTES) {
      return new ProbeResult(Support.NONE, "no events of 8 bytes follow its header lines");
    }
    return new ProbeResult(Support.CERTAIN, "it has the header of a DAT file");
  }

  @Override
  public RecordingReader openStream(RecordingFile file, ReadOptions options) throws IOException {
    PropheseeHeader header = PropheseeHeader.of(file);
    ViolationCounts found = new ViolationCounts();
    byte[] kind = file.read(header.dataOffset(), 2);
    int dataOffset = header.dataOffset() + kind.length;
    if (header.cutOff() || kind.length < 2) {
      found.add(Violation.CUT_OFF, dataOffset);
    } else if (kind[0] != EVENT_2D && kind[0] != CD) {
      throw new RecordingProblem(
          file.path(),
          header.dataOffset(),
          "events of type "
              + (kind[0] & 0xff)
              + " are not pixel events; only types 0 (2D) and 12 (CD) are read");
    } else if (kind[1] != DatDecoder.RECORD_BYTES) {
      throw new RecordingProblem(
          file.path(),
          header.dataOffset() + 1L,
          "events of " + (kind[1] & 0xff) + " bytes are unknown; they have 8");
    }
    List<String> remarks = new ArrayList<>();
    DatDecoder.DatLayout layout =
        header.value("version").orElse("2").startsWith("1")
            ? DatDecoder.DatLayout.VERSION_1
            : DatDecoder.DatLayout.VERSION_2;
    long firstTurnUs = firstTurnUs(header, remarks);
    PropheseeSensor sensor =
        PropheseeSensor.decide(
            header,
            options,
            MAX_SIDE,
            SIZES,
            any -> {
              file.requireFile(SensorGuess.ADVICE);
              return cursor(file, dataOffset, any, layout, firstTurnUs, new ViolationCounts());
            });
    sensor.remark().ifPresent(remarks::add);
    return new DecodingReader(
        name(),
        file,
        sensor.geometry(),
        remarks,
        options,
        found,
        violations -> cursor(file, dataOffset, sensor.geometry(), layout, firstTurnUs, violations));
  }

  private static EventCursor cursor(
      RecordingFile file,
      long dataOffset,
      SensorGeometry geometry,
      DatDecoder.DatLayout layout,
      long firstTurnUs,
      ViolationCounts violations) {
    return new FileCursor(
        file,
        dataOffset,
        ByteOrder.LITTLE_ENDIAN,
        new DatDecoder(geometry, layout, firstTurnUs, violations),
        violations);
  }

  private static long firstTurnUs(PropheseeHeader header, List<String> remarks) {
    try {
      long baseUs = Long.parseLong(header.value(TIME_BASE).orElse("0"));
      if (Math.abs(baseUs) <= MAX_BASE_US) {
        return baseUs;
      }
    } catch (NumberFormatException ignored) {
      // reported below
    }
    remarks.add("the header line " + TIME_BASE + " is impossible and is ignored");
    return 0;
  }

  @Override
  public Optional<RecordingWriter> create(Path file, WriteOptions options) throws IOException {
    return Optional.of(new DatWriter(file, options));
  }
}
