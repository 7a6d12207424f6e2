package haltere.ui.command;

import haltere.core.camera.Camera;
import haltere.core.chain.FilterChain;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingReader;
import haltere.core.json.Json;
import haltere.core.pipeline.Pipeline;
import haltere.core.pipeline.PipelineCounters;
import haltere.core.settings.SettingsProblem;
import haltere.core.sink.CsvSink;
import haltere.core.stream.StreamHandler;
import haltere.filters.wing.WingBeat;
import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingMethod;
import haltere.filters.wing.WingPair;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.tracker.WingTrackerFilter;
import haltere.ui.command.results.TextFile;
import haltere.ui.command.results.WingsSummary;
import haltere.ui.command.terminal.ProgressBar;
import haltere.ui.command.terminal.Quantities;
import haltere.ui.wing.WingLog;
import haltere.ui.wing.WingLogFormat;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Tracks the wings of a tethered fly through a recording. */
@Command(
    name = "wings",
    description = {
      "Track the wings of a tethered fly through a recording.",
      "OUT has a row for each edge and each wing at each tick of the rate; the angle is the"
          + " estimate at that time from events up to that time only."
    })
final class WingsCommand extends Subcommand {
  /** Runs what is to be tracked through a chain to sinks, to its end. */
  private interface Feed {
    void run(FilterChain chain, List<StreamHandler> sinks) throws IOException;
  }

  @Parameters(
      index = "0",
      arity = "0..1",
      paramLabel = "FILE",
      description = "A recording, if not a camera (--device).")
  Path file;

  @Option(
      names = "--out",
      required = true,
      paramLabel = "WINGS.csv",
      description = "Where the estimates go.")
  Path out;

  @Option(names = "--beats", paramLabel = "BEATS.csv", description = "Where the beats go.")
  Path beats;

  @Option(
      names = "--pairs",
      paramLabel = "PAIRS.csv",
      description = "Where left minus right, left plus right and the phase lag go.")
  Path pairs;

  @Option(
      names = "--geometry",
      paramLabel = "GEO.json",
      description = "Where body, heading and hinges go.")
  Path geometry;

  @Option(
      names = "--log",
      paramLabel = "LOG.txt",
      description = "Where a log goes whose first lines explain it.")
  Path log;

  @Option(
      names = "--log-rows",
      paramLabel = "event|tick|beat",
      description = "A row of the log for each event taken in, each tick (the default) or beat.")
  String logRows = "tick";

  @Option(
      names = "--log-layout",
      paramLabel = "table|original",
      description = "A table with commas (the default), or the original wing tracker's layout.")
  String logLayout = "table";

  @Option(
      names = "--method",
      paramLabel = "ekf|wra",
      description = "Extended Kalman filter (the default) or weighted running average.")
  String method;

  @Option(names = "--rate", paramLabel = "HZ", description = "Ticks a second; 1000 if not given.")
  Double rateHz;

  @Option(
      names = "--initial-frequency",
      paramLabel = "HZ",
      description = "The wing beat frequency, where it is known; it is found otherwise.")
  Double initialHz;

  @Option(names = "--flip-heading", description = "Exchange head and tail.")
  boolean flipHeading;

  @Option(
      names = "--preset",
      paramLabel = "NAME",
      description = "original: the method of 2006 with its defaults, for comparison.")
  String preset;

  @Option(
      names = "--set",
      paramLabel = "name=value",
      description = "A setting of the tracker, see: haltere filters; may be repeated.")
  List<String> assignments = List.of();

  @Mixin CameraOptionsGroup cameras;
  @Mixin PublishingOptions publishing;
  @Mixin ReadingOptions reading;

  @Option(names = "--overwrite", description = "Replace output files that exist.")
  boolean overwrite;

  WingsCommand(Surroundings surroundings) {
    super(surroundings);
  }

  @Override
  public Integer call() throws IOException {
    WingTrackerSettings settings = settings();
    cameras.checkOneSource(file);
    publishing.check();
    logFormat();
    checkOutputs();
    if (cameras.given()) {
      try (Camera camera = cameras.open(cameras.devices.get(0), false)) {
        track(camera.geometry(), settings, (chain, sinks) -> run(camera, chain, sinks));
      }
      return OK;
    }
    try (RecordingReader reader = reading.open(file)) {
      track(reader.geometry(), settings, (chain, sinks) -> run(reader, chain, sinks));
      warnings(reader);
    }
    return OK;
  }

  private void track(SensorGeometry sensor, WingTrackerSettings settings, Feed feed)
      throws IOException {
    WingTrackerFilter filter = new WingTrackerFilter(sensor, settings);
    FilterChain chain = new FilterChain(sensor);
    chain.add("wing-tracker", filter);
    WingsSummary summary = new WingsSummary(filter, settings.output().rateHz());
    try {
      run(feed, chain, filter, summary);
    } finally {
      chain.close();
    }
    summary.lines().forEach(this::result);
  }

  private void run(RecordingReader reader, FilterChain chain, List<StreamHandler> sinks)
      throws IOException {
    try (ProgressBar bar = progressBar("tracking", file)) {
      PipelineCounters counters = new PipelineCounters();
      List<StreamHandler> all = new ArrayList<>(sinks);
      all.add(new WritingSink(reader, null, bar, counters));
      Pipeline.run(reader, chain, all, counters);
    }
    reading.requireWhole(reader);
  }

  private void run(Camera camera, FilterChain chain, List<StreamHandler> sinks) throws IOException {
    LiveRun run = new LiveRun(this, camera, chain, sinks);
    LiveRun.run(List.of(run), cameras.durationS());
    run.summary();
  }

  private WingTrackerSettings settings() {
    WingTrackerSettings start =
        preset == null
            ? WingTrackerSettings.defaults()
            : preset(new WingTrackerFilter.Provider(), preset);
    List<String> all = new ArrayList<>();
    if (method != null) {
      all.add("filter.method=" + method(method));
    }
    if (rateHz != null) {
      all.add("output.rateHz=" + rateHz);
    }
    if (initialHz != null) {
      if (!(initialHz > 0)) {
        throw wrongArguments("--initial-frequency is " + initialHz + ", it must be above 0 Hz");
      }
      all.add("search.startFrequencyHz=" + initialHz);
    }
    if (flipHeading) {
      all.add("place.flipHeading=true");
    }
    all.addAll(assignments);
    try {
      return start.with(all.toArray(new String[0]));
    } catch (SettingsProblem problem) {
      throw wrongArguments(problem.getMessage());
    }
  }

  private WingMethod method(String name) {
    return switch (name.toLowerCase(Locale.ROOT)) {
      case "ekf" -> WingMethod.EKF;
      case "wra" -> WingMethod.WRA;
      default -> throw wrongArguments("--method is " + name + "; there are ekf and wra");
    };
  }

  private WingLogFormat logFormat() {
    WingLogFormat.Rows rows =
        switch (logRows.toLowerCase(Locale.ROOT)) {
          case "event" -> WingLogFormat.Rows.EVENT;
          case "tick" -> WingLogFormat.Rows.TICK;
          case "beat" -> WingLogFormat.Rows.BEAT;
          default ->
              throw wrongArguments("--log-rows is " + logRows + "; there are event, tick and beat");
        };
    WingLogFormat.Layout layout =
        switch (logLayout.toLowerCase(Locale.ROOT)) {
          case "table" -> WingLogFormat.Layout.TABLE;
          case "original" -> WingLogFormat.Layout.ORIGINAL;
          default ->
              throw wrongArguments("--log-layout is " + logLayout + "; there are table, original");
        };
    try {
      return new WingLogFormat(rows, layout);
    } catch (IllegalArgumentException problem) {
      throw wrongArguments("--log-rows: " + problem.getMessage());
    }
  }

  private void checkOutputs() throws IOException {
    WritingOptions writing = new WritingOptions();
    writing.overwrite = overwrite;
    Set<Path> seen = new HashSet<>();
    for (Path output : new Path[] {out, beats, pairs, geometry, log}) {
      if (output != null) {
        writing.check(output);
        if (file != null) {
          WritingOptions.checkDifferent(file, output);
        }
        if (!seen.add(output.toAbsolutePath().normalize())) {
          throw wrongArguments(output + " is named for two outputs");
        }
      }
    }
  }

  private void run(Feed feed, FilterChain chain, WingTrackerFilter filter, WingsSummary summary)
      throws IOException {
    List<Closeable> open = new ArrayList<>();
    try (Publishing published = publishing.open(chain, this)) {
      CsvSink<WingEstimate> rows = CsvSink.create(out, WingEstimate.class, overwrite);
      open.add(rows);
      chain.outlet("estimates", WingEstimate.class).subscribe(rows);
      CsvSink<WingBeat> beatRows = null;
      if (beats != null) {
        beatRows = CsvSink.create(beats, WingBeat.class, overwrite);
        open.add(beatRows);
        chain.outlet("beats", WingBeat.class).subscribe(beatRows);
      }
      CsvSink<WingPair> pairRows = null;
      if (pairs != null) {
        pairRows = CsvSink.create(pairs, WingPair.class, overwrite);
        open.add(pairRows);
        chain.outlet("pairs", WingPair.class).subscribe(pairRows);
      }
      WingLog wingLog = null;
      if (log != null) {
        String source = file == null ? cameras.devices.get(0) : file.getFileName().toString();
        wingLog = WingLog.open(log, source, filter, logFormat(), overwrite);
        open.add(wingLog);
      }
      summary.listenTo(chain);
      feed.run(chain, published.sinksAnd(summary));
      rows.finish();
      if (beatRows != null) {
        beatRows.finish();
      }
      if (pairRows != null) {
        pairRows.finish();
      }
      if (wingLog != null) {
        wingLog.finish();
      }
      if (geometry != null) {
        TextFile.write(geometry, Json.write(summary.geometry()) + "\n", overwrite);
      }
      message("wrote " + out + " (" + Quantities.count(rows.rows()) + " rows)");
    } finally {
      for (Closeable closeable : open) {
        closeable.close();
      }
    }
  }
}
