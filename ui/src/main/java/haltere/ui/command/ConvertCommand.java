package haltere.ui.command;

import haltere.core.chain.ChainProblem;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.event.SampleKind;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.Violation;
import haltere.core.pipeline.Conversion;
import haltere.ui.command.results.EventTable;
import haltere.ui.command.results.SampleExport;
import haltere.ui.command.results.SampleStream;
import haltere.ui.command.terminal.ProgressBar;
import haltere.ui.command.terminal.Quantities;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Copies a recording, or a part of it, to another format, with filters if requested. */
@Command(
    name = "convert",
    footer = {"", "Example: haltere convert recording.raw part.csv --from 0 --to 2000000"},
    description = "Write a recording, or a part of it, in the format given by OUT's ending.")
final class ConvertCommand extends Subcommand {
  /** Ending of events as a table, which nothing reads as a recording. */
  private static final String PARQUET = ".parquet";

  /** Names of the formats that {@code .raw} files may have. */
  private static final Map<String, String> ENCODINGS =
      Map.of("2", "evt2", "2.1", "evt21", "3", "evt3");

  /** Its header states the size of the sensor, so the next program reads it in one pass. */
  private static final String DEFAULT_STREAM = "es";

  private static final String STREAMED = "Event Stream, EVT, DAT, AEDAT-2.0 and CSV";

  @Parameters(
      index = "0",
      paramLabel = "IN",
      description = "A recording; - is standard input, for " + STREAMED + ".")
  Path in;

  @Parameters(
      index = "1",
      paramLabel = "OUT",
      description =
          "The new recording; - is standard output, for the same formats. OUT.parquet is a table of"
              + " its events.")
  Path out;

  @Option(
      names = "--from",
      paramLabel = "US",
      description = "First time to copy, in microseconds on the recording's own clock.")
  long fromUs = Long.MIN_VALUE;

  @Option(
      names = "--to",
      paramLabel = "US",
      description = "End of the part, in microseconds; events at this time are not copied.")
  long toUs = Long.MAX_VALUE;

  @Option(
      names = "--filter",
      paramLabel = "NAME",
      description = "Apply this filter with its default settings; may be repeated, in order.")
  List<String> filters = List.of();

  @Option(
      names = "--evt",
      paramLabel = "2|2.1|3",
      description = "Encoding of an OUT that ends in .raw: EVT2, EVT2.1 or EVT3 (default).")
  String evt;

  @Option(
      names = "--out-format",
      paramLabel = "NAME",
      description =
          "Format of standard output (es, evt2, evt21, evt3, dat, aedat2, csv); "
              + "default: the format of IN, or es if IN has another one.")
  String outFormat;

  @Option(
      names = "--stream",
      paramLabel = "NAME",
      description =
          "Write only the inertial samples (imu) or triggers (triggers) to a table "
              + "OUT, or the frames (frames) as PNG pictures to a new folder OUT.")
  SampleStream stream;

  @Mixin ReadingOptions reading;
  @Mixin RecordingWritingOptions writing;

  @Override
  public Integer call() throws IOException {
    checkArguments();
    if (stream != null || WritingOptions.hasEnding(out, PARQUET)) {
      writing.check(out);
    } else if (!ReadingOptions.isStandard(out)) {
      writing.checkRecording(out);
    }
    if (stream != null || !ReadingOptions.isStandard(out)) {
      WritingOptions.checkDifferent(in, out);
    }
    if (stream != null) {
      convertStream();
    } else {
      convert();
    }
    return OK;
  }

  /** The format stated by the user, by the name of OUT, or of the input. */
  private RecordingFormat format(RecordingReader reader) throws RecordingProblem {
    String named = evt == null ? outFormat : ENCODINGS.get(evt);
    if (named == null && !ReadingOptions.isStandard(out)) {
      return Recordings.forWriting(out);
    }
    RecordingFormat same = Recordings.formats().get(reader.formatName());
    boolean isSame = named == null && same != null && same.isStreamed() && same.writable();
    RecordingFormat format =
        isSame ? same : Recordings.formats().get(named == null ? DEFAULT_STREAM : named);
    writing.checkOrigin(format);
    return format;
  }

  private void checkArguments() {
    if (fromUs >= toUs) {
      throw wrongArguments("--from " + fromUs + " must be before --to " + toUs);
    }
    checkEncoding();
    try {
      filters.forEach(Filters::named);
    } catch (ChainProblem problem) {
      throw wrongArguments(problem.getMessage());
    }
    if (stream != null) {
      checkStream();
    }
  }

  private void checkEncoding() {
    if (outFormat != null) {
      if (!ReadingOptions.isStandard(out) || evt != null) {
        throw wrongArguments("--out-format needs - as OUT, and excludes --evt");
      }
      List<String> names = new ArrayList<>(Recordings.formats().keySet());
      names.removeIf(name -> !Recordings.formats().get(name).isStreamed());
      if (!names.contains(outFormat)) {
        throw wrongArguments("--out-format is " + outFormat + ", it must be one of " + names);
      }
    }
    if (evt != null && !ENCODINGS.containsKey(evt)) {
      throw wrongArguments("--evt is " + evt + ", it must be 2, 2.1 or 3");
    }
    boolean isRaw = ReadingOptions.isStandard(out) || WritingOptions.hasEnding(out, ".raw");
    if (evt != null && (stream != null || !isRaw)) {
      throw wrongArguments("--evt is for recordings in .raw files, which " + out + " is not");
    }
  }

  private void checkStream() {
    checkNeeded(false, "events, and excludes --stream", "--filter", "--origin");
    if (stream != SampleStream.FRAMES
        && Stream.of(".csv", PARQUET).noneMatch(ending -> WritingOptions.hasEnding(out, ending))) {
      throw wrongArguments("--stream writes a table; let " + out + " end in .csv or .parquet");
    }
  }

  private RecordingWriter writer(RecordingReader reader) throws IOException {
    return WritingOptions.hasEnding(out, PARQUET)
        ? new EventTable(
            out,
            writing.overwrite,
            reader.geometry(),
            Optional.ofNullable(writing.origin),
            provenance(in))
        : writing.create(out, format(reader), reader);
  }

  private void convertStream() throws IOException {
    long rows;
    List<String> warnings = new ArrayList<>();
    try (RecordingReader reader = reading.openWithReadings(in);
        ProgressBar bar = progressBar("converting", in)) {
      SampleExport export =
          new SampleExport(stream, out, writing.overwrite, fromUs, toUs, provenance(in));
      rows = export.run(reader, bar, () -> reading.requireComplete(reader));
      warnings.addAll(reader.remarks());
      warnings.addAll(reader.violations().describe(Set.of(Violation.OTHER_DATA)));
    }
    warnings(in, warnings);
    SampleKind kind =
        switch (stream) {
          case IMU -> SampleKind.INERTIAL_SAMPLE;
          case TRIGGERS -> SampleKind.TRIGGER;
          case FRAMES -> SampleKind.FRAME;
        };
    if (rows == 0) {
      warning(in + ": there are no " + kind.plural() + (isPart() ? " in this part" : ""));
    }
    message("wrote " + out + " (" + kind.count(rows) + ")");
  }

  private void convert() throws IOException {
    Conversion.Result done;
    try (RecordingReader reader = reading.openWithReadings(in);
        RecordingWriter writer = writer(reader);
        ProgressBar bar = progressBar("converting", in)) {
      FilterChain chain = chain(reader.geometry());
      Conversion conversion =
          new Conversion(
              fromUs, toUs, filters.isEmpty() ? Optional.empty() : Optional.of(chain), bar);
      done = conversion.run(reader, writer, reading.strict);
      chain.close();
    }
    warnings(in, done.warnings());
    warnings(out, done.losses());
    if (done.eventsRead() == 0) {
      warning(in + ": there are no events" + (isPart() ? " in this part" : ""));
    }
    message(
        "wrote %s (%s%s%s)",
        out,
        Quantities.events(done.eventsWritten()),
        filters.isEmpty() ? "" : " of " + Quantities.count(done.eventsRead()),
        done.samplesWritten().isEmpty() ? "" : ", " + done.samplesWritten());
  }

  private boolean isPart() {
    return fromUs > Long.MIN_VALUE || toUs < Long.MAX_VALUE;
  }

  private FilterChain chain(SensorGeometry geometry) {
    FilterChain chain = new FilterChain(geometry);
    for (String name : filters) {
      chain.add(Filters.named(name));
    }
    return chain;
  }
}
