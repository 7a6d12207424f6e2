package haltere.ui.command;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Outlet;
import haltere.core.event.SensorGeometry;
import haltere.core.format.AtomicFile;
import haltere.core.json.internal.Json;
import haltere.core.pipeline.JobReport;
import haltere.core.pipeline.JobResults;
import haltere.core.pipeline.RecordingJob;
import haltere.core.pipeline.ResultFiles;
import haltere.core.stream.StreamHandler;
import haltere.filters.wing.WingBeat;
import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingMethod;
import haltere.filters.wing.WingPair;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.tracker.WingTrackerFilter;
import haltere.ui.command.results.WingsSummary;
import haltere.ui.wing.WingLog;
import haltere.ui.wing.WingLogFormat;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Tracks the wings of a tethered fly in a recording. */
@Command(
    name = "wings",
    footer = {"", "Example: haltere wings fly.aedat4 --out wings.csv --report wings.html"},
    description = {
      "Track the wings of a tethered fly in a recording.",
      "OUT has a row for each edge and each wing at each tick of the rate. The "
          + "angle is the estimate at that time, from events up to that time only."
    })
final class WingsCommand extends Subcommand {
  private static final String TRACKER = "wing-tracker";

  @Parameters(arity = "0..1", paramLabel = "FILE", description = CameraOptionsGroup.FILE)
  Path file;

  @Option(
      names = "--out",
      required = true,
      paramLabel = "WINGS.csv",
      description =
          "Output table of the estimates: CSV, or Parquet by its ending, such as "
              + "WINGS.parquet. The other tables follow the same rule.")
  Path out;

  @Option(names = "--beats", paramLabel = "BEATS.csv", description = "Output table of the beats.")
  Path beats;

  @Option(
      names = "--pairs",
      paramLabel = "PAIRS.csv",
      description = "Output table of left minus right, left plus right and the phase lag.")
  Path pairs;

  @Option(
      names = "--geometry",
      paramLabel = "GEO.json",
      description = "Output file for body, heading and hinges.")
  Path geometry;

  @Option(
      names = "--log",
      paramLabel = "LOG.txt",
      description = "Output file for a log; its first lines explain it.")
  Path log;

  @Option(
      names = "--log-rows",
      paramLabel = "event|tick|beat",
      description = "Rows of the log: one for each accepted event, tick (default) or beat.")
  WingLogFormat.Rows logRows = WingLogFormat.Rows.TICK;

  @Option(
      names = "--log-layout",
      paramLabel = "table|original",
      description =
          "Layout of the log: comma-separated (default), or that of the original wing tracker.")
  WingLogFormat.Layout logLayout = WingLogFormat.Layout.TABLE;

  @Option(
      names = "--method",
      paramLabel = "ekf|wra",
      description = "Extended Kalman filter (the default) or weighted running average.")
  WingMethod method;

  @Option(names = "--rate", paramLabel = "HZ", description = "Ticks per second; default 1000.")
  Double rateHz;

  @Option(
      names = "--initial-frequency",
      paramLabel = "HZ",
      description = "The wing beat frequency, if known; default: estimated.")
  Double initialHz;

  @Option(names = "--flip-heading", description = "Exchange head and tail.")
  boolean flipHeading;

  @Option(
      names = "--preset",
      paramLabel = "NAME",
      description = "original: the tracker of Cardinale (2006) with its defaults, for comparison.")
  String preset;

  @Option(
      names = "--set",
      paramLabel = "name=value",
      description = "A setting of the tracker, see: haltere filters; may be repeated.")
  List<String> assignments = List.of();

  @Mixin CameraOptionsGroup cameras;
  @Mixin PublishingOptions publishing;
  @Mixin ReadingOptions reading;
  @Mixin WritingOptions writing;
  @Mixin ReportOptions reporting;

  private WingsSummary summary;

  @Override
  public Integer call() throws IOException {
    WingTrackerSettings settings = settings();
    cameras.checkOneSource(file);
    reading.checkNeeded(file, "--report");
    checkNeeded(log != null, "--log", "--log-rows", "--log-layout");
    publishing.check();
    logFormat();
    writing.check(
        Arrays.asList(file), Arrays.asList(out, beats, pairs, geometry, log, reporting.report));
    if (cameras.given()) {
      cameras.run(false, sensor -> chain(sensor, settings), (camera, chain) -> results(chain));
    } else {
      RecordingJob job =
          RecordingJob.of(
                  file, sensor -> chain(sensor, settings), (reader, chain) -> results(chain))
              .withReading(reading.readOptions(), reading.strict)
              .withOpening(reading::open);
      JobReport done = run(reporting.watching(job), "tracking", file);
      reporting.write(done, summary.lines(), writing.overwrite);
    }
    summary.lines().forEach(this::result);
    return OK;
  }

  private static FilterChain chain(SensorGeometry sensor, WingTrackerSettings settings) {
    FilterChain chain = new FilterChain(sensor);
    chain.add(TRACKER, new WingTrackerFilter(sensor, settings));
    return chain;
  }

  private JobResults results(FilterChain chain) throws IOException {
    return JobResults.all(() -> publishing.open(chain, this), () -> files(chain));
  }

  private JobResults files(FilterChain chain) throws IOException {
    WingTrackerFilter filter = (WingTrackerFilter) chain.stage(TRACKER).filter();
    summary = new WingsSummary(filter, filter.settings().output().rateHz());
    return ResultFiles.open(
        writing::begin,
        provenance(file).chain(chain),
        files -> {
          table(files, filter.results(WingEstimate.class), out);
          table(files, filter.results(WingBeat.class), beats);
          table(files, filter.results(WingPair.class), pairs);
          if (log != null) {
            String source = file == null ? cameras.devices.get(0) : file.getFileName().toString();
            WingLog wingLog = WingLog.open(writing.begin(log), source, filter, logFormat());
            files.add(log, wingLog::rows, wingLog, wingLog::finish);
          }
          summary.listenTo(chain);
          files.add((StreamHandler) summary, this::writeGeometry);
        });
  }

  private void writeGeometry() throws IOException {
    if (geometry != null) {
      AtomicFile.write(geometry, Json.write(summary.geometry()) + "\n", writing.overwrite);
      message("wrote " + geometry);
    }
  }

  private static <R extends Record> void table(ResultFiles files, Outlet<R> outlet, Path file)
      throws IOException {
    if (file != null) {
      files.write(outlet, file);
    }
  }

  private WingTrackerSettings settings() {
    WingTrackerSettings start =
        preset == null
            ? WingTrackerSettings.defaults()
            : preset(new WingTrackerFilter.Provider(), preset);
    checkRange(initialHz == null || initialHz > 0, "--initial-frequency", initialHz, "above 0 Hz");
    Map<String, Object> options = new LinkedHashMap<>();
    options.put("filter.method", method);
    options.put("output.rateHz", rateHz);
    options.put("search.startFrequencyHz", initialHz);
    options.put("position.flipHeading", flipHeading ? true : null);
    return assigned(WingTrackerSettings.class, start, options, assignments);
  }

  private WingLogFormat logFormat() {
    try {
      return new WingLogFormat(logRows, logLayout);
    } catch (IllegalArgumentException problem) {
      throw wrongArguments("--log-rows: " + problem.getMessage());
    }
  }
}
