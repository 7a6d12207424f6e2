package haltere.core.format.internal.evt;

import haltere.core.event.SampleKind;
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
import haltere.core.format.internal.decoding.SensorGuess;
import haltere.core.format.internal.decoding.StreamedFormat;
import haltere.core.format.internal.reader.DecodingReader;
import java.io.IOException;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/** Common part of the three encodings of Prophesee RAW files. */
abstract sealed class EvtFormat implements StreamedFormat
    permits Evt2Format, Evt21Format, Evt3Format {
  /** Key of Haltere's header line: start time of the first clock period. */
  static final String TIME_BASE = "haltere_time_base_us";

  static final long MAX_BASE_US = 1L << 61;

  /** The encoding's name in the header line {@code format}. */
  abstract String encoding();

  /** A decoder before the first word. */
  abstract EvtDecoder decoder(
      SensorGeometry geometry, long firstTurnUs, ViolationCounts violations);

  /** The words of the encoding. */
  abstract TriggerWords.WordEncoding words();

  /** Detects the variant of the encoding; returns the format of the variant. */
  EvtFormat fitted(RecordingFile file, PropheseeHeader header, List<String> remarks)
      throws IOException {
    return this;
  }

  /** The encoding stated in a header. */
  static Optional<String> stated(PropheseeHeader header) {
    Optional<String> format = header.value("format");
    if (format.isPresent()) {
      String name = format.get().split(";", 2)[0].strip().toUpperCase(Locale.ROOT);
      return Optional.of(name.replace("EVT2.1", "EVT21").replaceFirst("^(EVT[23])\\.0$", "$1"));
    }
    return header
        .value("evt")
        .map(version -> "EVT" + version.replace(".0", "").replace(".", "").strip());
  }

  /** Edges on inputs; the words cannot represent other triggers. */
  @Override
  public Set<SampleKind> writableSamples() {
    return Set.of(SampleKind.TRIGGER);
  }

  @Override
  public ProbeResult probe(FileHead head) {
    PropheseeHeader header = PropheseeHeader.parse(head.head(), head.head().length >= head.size());
    Optional<String> stated = stated(header);
    if (stated.isEmpty()) {
      return new ProbeResult(Support.NONE, "no line % format or % evt names " + encoding());
    }
    boolean own = stated.get().equals(encoding());
    return new ProbeResult(own ? Support.CERTAIN : Support.NONE, "its header says " + stated.get());
  }

  @Override
  public RecordingReader openStream(RecordingFile file, ReadOptions options) throws IOException {
    PropheseeHeader header = PropheseeHeader.of(file);
    List<String> remarks = new ArrayList<>();
    Optional<String> stated = stated(header);
    if (stated.isEmpty()) {
      remarks.add("no header line names the encoding; it is read as " + encoding());
    } else if (!stated.get().equals(encoding())) {
      throw new RecordingProblem(
          file.path(),
          "the header says " + stated.get() + ", not " + encoding() + "; leave out --format");
    }
    EvtFormat fitted = fitted(file, header, remarks);
    long firstTurnUs = firstTurnUs(header, remarks);
    ViolationCounts found = new ViolationCounts();
    if (header.cutOff()) {
      found.add(Violation.CUT_OFF, header.dataOffset());
    }
    PropheseeSensor sensor =
        PropheseeSensor.decide(
            header,
            options,
            EvtDecoder.MAX_SIDE,
            PropheseeSensor.RAW_SIZES,
            any -> {
              file.requireFile(SensorGuess.ADVICE);
              return fitted.cursor(file, header, any, firstTurnUs, new ViolationCounts());
            });
    sensor.remark().ifPresent(remarks::add);
    return new DecodingReader(
        name(),
        file,
        sensor.geometry(),
        remarks,
        options,
        found,
        violations -> fitted.cursor(file, header, sensor.geometry(), firstTurnUs, violations),
        Optional.of(
            violations ->
                new EvtSampleCursor(
                    file, header.dataOffset(), new TriggerWords(fitted.words(), firstTurnUs))));
  }

  private EventCursor cursor(
      RecordingFile file,
      PropheseeHeader header,
      SensorGeometry geometry,
      long firstTurnUs,
      ViolationCounts violations) {
    return new FileCursor(
        file,
        header.dataOffset(),
        ByteOrder.LITTLE_ENDIAN,
        decoder(geometry, firstTurnUs, violations),
        violations);
  }

  private static long firstTurnUs(PropheseeHeader header, List<String> remarks) {
    String text = header.value(TIME_BASE).orElse("0");
    try {
      long baseUs = Long.parseLong(text);
      if (Math.abs(baseUs) <= MAX_BASE_US) {
        return baseUs;
      }
    } catch (NumberFormatException ignored) {
      // reported below
    }
    remarks.add("the header line " + TIME_BASE + " is impossible and is ignored");
    return 0;
  }
}
