package haltere.ui.command;

import haltere.core.camera.Camera;
import haltere.core.chain.ChainFile;
import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.chain.FilterTiming;
import haltere.core.chain.Outlet;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadingCounts;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.Violation;
import haltere.core.pipeline.OverflowPolicy;
import haltere.core.pipeline.Pipeline;
import haltere.core.pipeline.PipelineCounters;
import haltere.core.pipeline.Recorder;
import haltere.core.pipeline.RecorderReport;
import haltere.core.pipeline.SessionRecorder;
import haltere.core.pipeline.SessionRecorder.Limits;
import haltere.core.playback.PacedSource;
import haltere.core.playback.PlaybackClock;
import haltere.core.playback.Sleeper;
import haltere.core.stream.EventSource;
import haltere.core.stream.StreamHandler;
import haltere.ui.command.results.OutletTables;
import haltere.ui.command.terminal.ProgressBar;
import haltere.ui.command.terminal.Quantities;
import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Runs a saved chain over a recording. */
@Command(
    name = "run",
    description = {
      "Run a saved chain of filters over a recording.",
      "Without --out: say what each filter let through and what it cost. With --out: also write"
          + " the events that are left, with frames, inertial samples and triggers where its"
          + " format can hold them, and what the filters publish to CSV files beside them,"
          + " named OUT.STAGE.OUTLET.csv."
    })
final class RunCommand extends Subcommand {
  @Parameters(
      index = "0",
      arity = "0..1",
      paramLabel = "FILE",
      description = "A recording, if not a camera (--device).")
  Path file;

  @Option(
      names = "--chain",
      required = true,
      paramLabel = "CHAIN.json",
      description = "A chain that the viewer saved, or written by hand.")
  Path chainFile;

  @Option(
      names = "--out",
      paramLabel = "OUT",
      description = "Where the events that are left go; the format follows from the name's ending.")
  Path out;

  @Option(
      names = "--speed",
      paramLabel = "FACTOR",
      description =
          "As a camera would give it: 1 in real time, 0.1 ten times slower; as fast as possible if"
              + " not given.")
  double speed = Double.POSITIVE_INFINITY;

  @Mixin CameraOptionsGroup cameras;
  @Mixin PublishingOptions publishing;
  @Mixin ReadingOptions reading;
  @Mixin RecordingWritingOptions writing;

  RunCommand(Surroundings surroundings) {
    super(surroundings);
  }

  @Override
  public Integer call() throws IOException {
    cameras.checkOneSource(file);
    publishing.check();
    if (!(speed >= PlaybackClock.MIN_SPEED)) {
      throw wrongArguments("--speed must be " + PlaybackClock.MIN_SPEED + " or more");
    }
    if (out != null) {
      writing.checkRecording(out);
      if (file != null) {
        WritingOptions.checkDifferent(file, out);
      }
    }
    if (cameras.given()) {
      runCamera();
      return OK;
    }
    try (RecordingReader reader = reading.openWithReadings(file)) {
      FilterChain chain = chain(reader.geometry());
      try {
        if (out == null) {
          run(reader, chain, null);
          reading.requireWhole(reader);
          warnings(reader);
        } else {
          runAndWrite(reader, chain);
        }
      } finally {
        chain.close();
      }
      summary(chain);
    }
    return OK;
  }

  private void runCamera() throws IOException {
    Camera camera = cameras.open(cameras.devices.get(0), out != null);
    FilterChain chain = null;
    try (Publishing published = new Publishing(this)) {
      chain = chain(camera.geometry());
      List<StreamHandler> sinks = new ArrayList<>(publishing.open(chain, published).sinks());
      if (out == null) {
        runCamera(camera, chain, sinks);
      } else {
        recordCamera(camera, chain, sinks);
      }
      summary(chain);
    } finally {
      camera.close();
      if (chain != null) {
        chain.close();
      }
    }
  }

  private void runCamera(Camera camera, FilterChain chain, List<StreamHandler> sinks)
      throws IOException {
    LiveRun run = new LiveRun(this, camera, chain, sinks);
    LiveRun.run(List.of(run), cameras.durationS());
    run.summary();
  }

  private void recordCamera(Camera camera, FilterChain chain, List<StreamHandler> sinks)
      throws IOException {
    checkTables(chain);
    try (SessionRecorder recorder =
            writing.session(out, camera, () -> Optional.of(ChainFile.write(chain)), Limits.USUAL);
        OutletTables tables = OutletTables.open(chain, this::table, writing.overwrite)) {
      sinks.add(recorder);
      runCamera(camera, chain, sinks);
      tables.finish();
      for (SessionRecorder.Part part : recorder.finish()) {
        message("wrote " + part.file() + " (" + Quantities.events(part.report().written()) + ")");
      }
      RecordingWritingOptions.endedEarly(recorder).ifPresent(this::failedBeside);
      tables
          .rows()
          .forEach(
              (table, count) ->
                  message("wrote " + table + " (" + Quantities.count(count) + " rows)"));
    }
  }

  private FilterChain chain(SensorGeometry geometry) throws IOException {
    try {
      return ChainFile.read(chainFile, geometry, this::warning);
    } catch (CharacterCodingException notText) {
      throw Failures.notText(chainFile, notText);
    }
  }

  private void runAndWrite(RecordingReader reader, FilterChain chain) throws IOException {
    checkTables(chain);
    Map<Path, Long> rows;
    Passed passed;
    RecorderReport report;
    RecordingWriter writer = writing.create(out, Recordings.forWriting(out), reader);
    try (Recorder recorder = new Recorder(writer, reader.geometry(), OverflowPolicy.BLOCK);
        OutletTables tables = OutletTables.open(chain, this::table, writing.overwrite)) {
      passed = run(reader, chain, recorder);
      reading.requireWhole(reader);
      tables.finish();
      report = recorder.finish();
      for (String loss : writer.losses()) {
        warning(out + ": " + loss);
      }
      rows = tables.rows();
    }
    boolean readings = !passed.readings().isEmpty();
    warnings(reader, readings ? Set.of(Violation.OTHER_DATA) : Set.of());
    ReadingCounts leftOut = report.readingsLeftOut();
    if (!leftOut.isEmpty()) {
      warning(file + ": " + leftOut + " were left out: the format of " + out + " cannot hold them");
    }
    ReadingCounts written = passed.readings().minus(leftOut);
    message(
        "wrote "
            + out
            + " ("
            + Quantities.events(passed.events())
            + (written.isEmpty() ? "" : ", " + written)
            + ")");
    rows.forEach(
        (table, count) -> message("wrote " + table + " (" + Quantities.count(count) + " rows)"));
  }

  private void checkTables(FilterChain chain) throws IOException {
    Set<Path> seen = new HashSet<>(List.of(out));
    for (Path table : OutletTables.files(chain, this::table)) {
      writing.check(table);
      if (file != null) {
        WritingOptions.checkDifferent(file, table);
      }
      if (!seen.add(table)) {
        throw new CommandProblem(
            chainFile + ": two stages of the same name would both write " + table);
      }
    }
  }

  /** Beside OUT: {@code left.aedat} has {@code left.cluster-tracker.clusters.csv}. */
  private Path table(ChainStage stage, Outlet<?> outlet) {
    String name = out.getFileName().toString();
    int dot = name.lastIndexOf('.');
    String stem = dot > 0 ? name.substring(0, dot) : name;
    return out.resolveSibling(stem + "." + stage.name() + "." + outlet.name() + ".csv");
  }

  /** What a chain left of a recording. */
  private record Passed(long events, ReadingCounts readings) {}

  /** Runs the whole recording through the chain. */
  private Passed run(RecordingReader reader, FilterChain chain, Recorder recorder)
      throws IOException {
    try (ProgressBar bar = progressBar("filtering", file);
        Publishing published = publishing.open(chain, this)) {
      PipelineCounters counters = new PipelineCounters();
      WritingSink sink = new WritingSink(reader, recorder, bar, counters);
      Pipeline.run(paced(reader), chain, published.sinksAnd(sink), counters);
      return new Passed(counters.get(PipelineCounters.Counter.EVENTS_OUT), sink.readings());
    }
  }

  private EventSource paced(EventSource source) {
    if (Double.isInfinite(speed)) {
      return source;
    }
    PlaybackClock clock = new PlaybackClock(System::nanoTime, Sleeper.real());
    clock.setSpeed(speed);
    return new PacedSource(source, clock);
  }

  private void summary(FilterChain chain) {
    result(
        String.format(
            Locale.ROOT, "%-24s %14s %14s %8s %12s", "stage", "in", "out", "kept", "ns/event"));
    for (ChainStage stage : chain.stages()) {
      FilterTiming timing = stage.timing();
      result(
          String.format(
              Locale.ROOT,
              "%-24s %,14d %,14d %6.1f %% %12.1f",
              stage.name() + (stage.isEnabled() ? "" : " (off)"),
              timing.eventsIn(),
              timing.eventsOut(),
              timing.eventsIn() == 0 ? 0 : 100.0 * timing.eventsOut() / timing.eventsIn(),
              timing.microsPerThousandEvents()));
    }
  }
}
