package haltere.ui.command;

import haltere.core.camera.Camera;
import haltere.core.chain.ChainFile;
import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.chain.FilterTiming;
import haltere.core.chain.Outlet;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.pipeline.JobReport;
import haltere.core.pipeline.JobResults;
import haltere.core.pipeline.OutletTables;
import haltere.core.pipeline.RecordingJob;
import haltere.core.pipeline.SessionRecorder.Limits;
import haltere.core.playback.PlaybackClock;
import haltere.core.playback.Sleeper;
import haltere.core.playback.internal.PacedSource;
import haltere.core.sink.Tables;
import haltere.core.stream.EventSource;
import haltere.ui.command.terminal.Quantities;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Runs a saved chain over a recording. */
@Command(
    name = "run",
    footer = {"", "Example: haltere run recording.aedat4 --chain chain.json --out left.aedat4"},
    description = {
      "Run a saved chain of filters over a recording.",
      "Prints for each filter the events passed and the processor time. With --out, also writes "
          + "the remaining events, with frames, inertial samples and triggers if the format holds "
          + "them. Results of the filters go to tables beside them, OUT.STAGE.OUTLET.csv."
    })
final class RunCommand extends Subcommand {
  @Parameters(arity = "0..1", paramLabel = "FILE", description = CameraOptionsGroup.FILE)
  Path file;

  @Option(
      names = "--chain",
      required = true,
      paramLabel = "CHAIN.json",
      description = "A chain of filters, saved by the viewer or written by hand.")
  Path chainFile;

  @Option(
      names = "--out",
      paramLabel = "OUT",
      description = "File for the remaining events; its ending gives the format.")
  Path out;

  @Option(
      names = "--speed",
      paramLabel = "FACTOR",
      description =
          "Playback speed: 1 is real time, 0.1 ten times slower; default: as fast as possible.")
  double speed = Double.POSITIVE_INFINITY;

  @Option(
      names = "--tables",
      paramLabel = "csv|parquet",
      defaultValue = Tables.CSV,
      description = "Format of the tables of results; default csv.")
  String tables;

  @Mixin CameraOptionsGroup cameras;
  @Mixin PublishingOptions publishing;
  @Mixin ReadingOptions reading;
  @Mixin RecordingWritingOptions writing;
  @Mixin ReportOptions reporting;

  @Override
  public Integer call() throws IOException {
    cameras.checkOneSource(file);
    reading.checkNeeded(file, "--report", "--speed");
    checkNeeded(out != null, "--out", "--tables", "--origin");
    publishing.check();
    checkTables("--tables", tables);
    if (!(speed >= PlaybackClock.MIN_SPEED)) {
      throw wrongArguments(
          Quantities.text("--speed must be %.4f or more", PlaybackClock.MIN_SPEED));
    }
    if (out != null) {
      writing.checkRecording(out);
    }
    writing.check(Arrays.asList(file, chainFile), Arrays.asList(out, reporting.report));
    if (cameras.given()) {
      summary(cameras.run(out != null, this::chain, this::results));
      return OK;
    }
    RecordingJob job =
        RecordingJob.of(file, this::chain, this::results)
            .withReading(reading.readOptions().withSamples(true), reading.strict)
            .withOpening(reading::open)
            .withPacing(this::paced);
    JobReport done = run(reporting.watching(job), "filtering", file);
    summary(done.stages());
    reporting.write(done, List.of(), writing.overwrite);
    return OK;
  }

  private FilterChain chain(SensorGeometry geometry) throws IOException {
    return ChainFile.read(chainFile, geometry, this::warning);
  }

  private JobResults results(RecordingReader reader, FilterChain chain) throws IOException {
    RecordingFormat format = out == null ? null : Recordings.forWriting(out);
    return results(
        chain, () -> new WrittenRecording(this, reader, out, writing.create(out, format, reader)));
  }

  private JobResults results(Camera camera, FilterChain chain) throws IOException {
    Supplier<Optional<String>> text = () -> Optional.of(ChainFile.write(chain));
    return results(
        chain, () -> new SessionResults(this, writing.session(out, camera, text, Limits.DEFAULT)));
  }

  private JobResults results(FilterChain chain, JobResults.Opener events) throws IOException {
    if (out == null) {
      return publishing.open(chain, this);
    }
    checkTables(chain);
    return JobResults.all(() -> publishing.open(chain, this), events, () -> tables(chain));
  }

  private JobResults tables(FilterChain chain) throws IOException {
    return OutletTables.open(chain, this::table, writing::begin, provenance(file).chain(chain));
  }

  private void checkTables(FilterChain chain) throws IOException {
    List<Path> outputs = new ArrayList<>(OutletTables.files(chain, this::table));
    outputs.addAll(Arrays.asList(out, reporting.report));
    writing.check(Arrays.asList(file, chainFile), outputs);
  }

  /** Beside OUT: {@code left.aedat} has {@code left.cluster-tracker.clusters.csv}. */
  private Path table(ChainStage stage, Outlet<?> outlet) {
    String name = out.getFileName().toString();
    int dot = name.lastIndexOf('.');
    String stem = dot > 0 ? name.substring(0, dot) : name;
    return out.resolveSibling(stem + "." + stage.name() + "." + outlet.name() + "." + tables);
  }

  private EventSource paced(EventSource source) {
    if (Double.isInfinite(speed)) {
      return source;
    }
    PlaybackClock clock = new PlaybackClock(System::nanoTime, Sleeper.real());
    clock.setSpeed(speed);
    return new PacedSource(source, clock);
  }

  private void summary(List<JobReport.Stage> stages) {
    result("%-24s %14s %14s %8s %12s", "stage", "in", "out", "kept", "ns/event");
    for (JobReport.Stage stage : stages) {
      FilterTiming timing = stage.timing();
      result(
          "%-24s %,14d %,14d %6.1f %% %12.1f",
          stage.name() + (stage.enabled() ? "" : " (off)"),
          timing.eventsIn(),
          timing.eventsOut(),
          timing.eventsIn() == 0 ? 0 : 100.0 * timing.eventsOut() / timing.eventsIn(),
          timing.microsPerThousandEvents());
    }
  }
}
