package haltere.ui.command;

import haltere.core.camera.Camera;
import haltere.core.chain.ChainFile;
import haltere.core.chain.ChainStage;
import haltere.core.chain.ConfigurableFilter;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingReader;
import haltere.core.pipeline.Pipeline;
import haltere.core.pipeline.PipelineCounters;
import haltere.core.settings.SettingsProblem;
import haltere.core.settings.SettingsSchema;
import haltere.core.sink.CsvSink;
import haltere.filters.object.ObjectTrack;
import haltere.filters.object.ObjectTrackerFilter;
import haltere.filters.object.ObjectTrackerSettings;
import haltere.filters.plane.PlanePoint;
import haltere.filters.road.LineCounter;
import haltere.filters.road.LineCrossing;
import haltere.filters.track.KalmanTracksFilter;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.TrackPoint;
import haltere.ui.command.results.RoadObjectRow;
import haltere.ui.command.results.RoadTrackRow;
import haltere.ui.command.terminal.ProgressBar;
import haltere.ui.command.terminal.Quantities;
import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Tracks what moves in a recording and writes a table of it. */
@Command(
    name = "track",
    description = {
      "Track what moves in a recording or before a camera and write where it is, how fast, how"
          + " large, and how sure that is.",
      "A row for each visible object at each tick of the rate, from events before that time only;"
          + " whether it is an object is decided up to 2 s later."
    })
final class TrackCommand extends Subcommand {
  private static final String OBJECTS = "object-tracker";
  private static final String CLUSTERS = "kalman-tracks";

  /** Runs what is to be tracked through a chain, to its end. */
  private interface Feed {
    void run(FilterChain chain) throws IOException;
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
      paramLabel = "TRACKS.csv",
      description = "Where the table goes.")
  Path out;

  @Option(
      names = "--rate",
      paramLabel = "HZ",
      defaultValue = "100",
      description = "Rows of each track a second of recording time; 100 if not given.")
  double rateHz;

  @Option(
      names = "--chain",
      paramLabel = "CHAIN.json",
      description =
          "A chain of filters; one without "
              + OBJECTS
              + " or "
              + CLUSTERS
              + " gets the first at its end. If not given: "
              + OBJECTS
              + " alone, which needs no noise filter.")
  Path chainFile;

  @Option(
      names = "--preset",
      paramLabel = "NAME",
      description =
          "original: the Kalman filter on clusters of Cardinale (2006) with its defaults, for"
              + " comparison; not with --chain.")
  String preset;

  @Option(
      names = "--set",
      paramLabel = "name=value",
      description =
          "A setting of "
              + OBJECTS
              + " (with --preset: of "
              + CLUSTERS
              + "), see: haltere filters; may be repeated.")
  List<String> assignments = List.of();

  @Option(
      names = "--road",
      paramLabel = "ROAD.json",
      description = {
        "The road that the camera looks along: tracks are on it, and columns in metres are added."
            + " Keys: bridgeHeightM, nearestM, farthestM, vanishingPoint {xPx, yPx}, lanes {lanes,"
            + " leftEdgeM, widthM}, countingLines {lines, firstM, apartM}, vehicles (what is usual);"
            + " all may be left out. Or any plane: four points {xPx, yPx, xM, yM}."
      })
  Path roadFile;

  @Option(
      names = "--crossings",
      paramLabel = "CROSSINGS.csv",
      description =
          "Table of the tracks that crossed a counting line of the road (--road): time, lane,"
              + " direction, speed and counts.")
  Path crossings;

  @Mixin CameraOptionsGroup cameras;
  @Mixin PublishingOptions publishing;
  @Mixin ReadingOptions reading;
  @Mixin WritingOptions writing;

  /** The settings of the preset; null for those of the chain. */
  private KalmanTracksSettings start;

  TrackCommand(Surroundings surroundings) {
    super(surroundings);
  }

  @Override
  public Integer call() throws IOException {
    if (!(rateHz >= 0.001 && rateHz <= 100_000)) {
      throw wrongArguments("--rate is " + rateHz + ", it must be from 0.001 to 100000 Hz");
    }
    cameras.checkOneSource(file);
    publishing.check();
    writing.check(out);
    if (crossings != null) {
      if (roadFile == null) {
        throw wrongArguments("--crossings needs a road with counting lines, see --road");
      }
      writing.check(crossings);
      WritingOptions.checkDifferent(out, crossings);
    }
    if (preset != null) {
      if (chainFile != null) {
        throw wrongArguments("--preset and --chain both say how to track");
      }
      start = preset(new KalmanTracksFilter.Provider(), preset);
    }
    for (Path input : inputs()) {
      WritingOptions.checkDifferent(input, out);
      if (crossings != null) {
        WritingOptions.checkDifferent(input, crossings);
      }
    }
    if (cameras.given()) {
      trackCamera();
    } else {
      trackRecording();
    }
    return OK;
  }

  private void trackRecording() throws IOException {
    try (RecordingReader reader = reading.open(file)) {
      FilterChain chain = chain(reader.geometry());
      try {
        track(chain, whole -> run(reader, whole));
      } finally {
        chain.close();
      }
      warnings(reader);
    }
  }

  private void trackCamera() throws IOException {
    try (Camera camera = cameras.open(cameras.devices.get(0), false)) {
      FilterChain chain = chain(camera.geometry());
      try {
        track(chain, whole -> run(camera, whole));
      } finally {
        chain.close();
      }
    }
  }

  private List<Path> inputs() {
    return Stream.of(file, chainFile, roadFile).filter(Objects::nonNull).toList();
  }

  private FilterChain chain(SensorGeometry geometry) throws IOException {
    if (chainFile == null) {
      FilterChain chain = new FilterChain(geometry);
      (start == null ? List.of(OBJECTS) : List.of("background-activity", "hot-pixels", CLUSTERS))
          .forEach(name -> chain.add(Filters.named(name)));
      return chain;
    }
    try {
      return ChainFile.read(chainFile, geometry, this::warning);
    } catch (CharacterCodingException notText) {
      throw Failures.notText(chainFile, notText);
    }
  }

  /** The road, or null if there is none. */
  private RoadFile road() throws IOException {
    if (roadFile == null) {
      return null;
    }
    try {
      RoadFile road = RoadFile.read(roadFile);
      if (crossings != null && road.lines().lines() == 0) {
        throw wrongArguments("--crossings needs counting lines, and " + roadFile + " has none");
      }
      return road;
    } catch (CharacterCodingException notText) {
      throw Failures.notText(roadFile, notText);
    }
  }

  private static <F extends ConfigurableFilter<?>> F last(FilterChain chain, Class<F> type) {
    F found = null;
    for (ChainStage stage : chain.stages()) {
      if (stage.isEnabled() && stage.filter() instanceof FilterChain nested) {
        F inside = last(nested, type);
        found = inside == null ? found : inside;
      } else if (stage.isEnabled() && type.isInstance(stage.filter())) {
        found = type.cast(stage.filter());
      }
    }
    return found;
  }

  private void track(FilterChain chain, Feed feed) throws IOException {
    ObjectTrackerFilter objects = last(chain, ObjectTrackerFilter.class);
    KalmanTracksFilter clusters = last(chain, KalmanTracksFilter.class);
    if (objects == null && clusters != null) {
      trackClusters(clusters, chain, feed);
      return;
    }
    if (objects == null) {
      objects = new ObjectTrackerFilter(chain.geometry(), ObjectTrackerSettings.defaults());
      chain.add(OBJECTS, objects);
    }
    objects.apply(assigned(ObjectTrackerSettings.class, objects.settings(), "reportRateHz"));
    RoadFile road = road();
    if (road == null) {
      try (CsvSink<ObjectTrack> table = CsvSink.create(out, ObjectTrack.class, writing.overwrite)) {
        run(objects, chain, feed, table);
        finish(table, out);
      }
      return;
    }
    Function<ObjectTrack, Optional<PlanePoint>> onRoad = road.objects(chain.geometry());
    objects.apply(road.motion(chain.geometry()));
    try (CsvSink<RoadObjectRow> table =
            CsvSink.create(out, RoadObjectRow.class, writing.overwrite);
        CsvSink<LineCrossing> counts = counts()) {
      Consumer<PlanePoint> counter = counter(road, counts);
      run(
          objects,
          chain,
          feed,
          track ->
              onRoad
                  .apply(track)
                  .ifPresent(
                      point -> {
                        table.accept(RoadObjectRow.of(track, point, road.lanes()));
                        counter.accept(point);
                      }));
      finish(table, out);
      if (counts != null) {
        finish(counts, crossings);
      }
    }
  }

  private static void run(
      ObjectTrackerFilter objects, FilterChain chain, Feed feed, Consumer<ObjectTrack> sink)
      throws IOException {
    OrderedTracks ordered = new OrderedTracks(sink);
    objects.tracks().subscribe(ordered);
    feed.run(chain);
    ordered.finish();
  }

  private void trackClusters(KalmanTracksFilter tracks, FilterChain chain, Feed feed)
      throws IOException {
    KalmanTracksSettings settings = start == null ? tracks.settings() : start;
    RoadFile road = road();
    if (road != null) {
      settings = settings.onRoad(road.tracks(settings.road()));
    }
    tracks.apply(assigned(KalmanTracksSettings.class, settings, "clusters.output.reportRateHz"));
    if (road == null) {
      try (CsvSink<TrackPoint> table = CsvSink.create(out, TrackPoint.class, writing.overwrite)) {
        tracks.points().subscribe(table);
        feed.run(chain);
        finish(table, out);
      }
      return;
    }
    try (CsvSink<RoadTrackRow> table = CsvSink.create(out, RoadTrackRow.class, writing.overwrite);
        CsvSink<LineCrossing> counts = counts()) {
      // A track's position in the picture is published before its position on the road.
      TrackPoint[] inPicture = new TrackPoint[1];
      tracks.points().subscribe(point -> inPicture[0] = point);
      tracks
          .roadPoints()
          .subscribe(onRoad -> table.accept(RoadTrackRow.of(inPicture[0], onRoad, road.lanes())));
      tracks.roadPoints().subscribe(counter(road, counts));
      feed.run(chain);
      finish(table, out);
      if (counts != null) {
        finish(counts, crossings);
      }
    }
  }

  /** The table of crossings, or null if none is wanted. */
  private CsvSink<LineCrossing> counts() throws IOException {
    return crossings == null
        ? null
        : CsvSink.create(crossings, LineCrossing.class, writing.overwrite);
  }

  private static Consumer<PlanePoint> counter(RoadFile road, CsvSink<LineCrossing> counts) {
    return counts == null ? point -> {} : new LineCounter(road.lanes(), road.lines(), counts);
  }

  private <S extends Record> S assigned(Class<S> type, S settings, String rate) {
    try {
      List<String> all =
          Stream.concat(assignments.stream(), Stream.of(rate + "=" + rateHz)).toList();
      return SettingsSchema.of(type).withAssignments(settings, all);
    } catch (SettingsProblem problem) {
      throw wrongArguments(problem.getMessage());
    }
  }

  private void finish(CsvSink<?> table, Path path) throws IOException {
    table.finish();
    message("wrote " + path + " (" + Quantities.count(table.rows()) + " rows)");
  }

  private void run(RecordingReader reader, FilterChain chain) throws IOException {
    try (ProgressBar bar = progressBar("tracking", file);
        Publishing published = publishing.open(chain, this)) {
      PipelineCounters counters = new PipelineCounters();
      WritingSink progress = new WritingSink(reader, null, bar, counters);
      Pipeline.run(reader, chain, published.sinksAnd(progress), counters);
    }
    reading.requireWhole(reader);
  }

  private void run(Camera camera, FilterChain chain) throws IOException {
    try (Publishing published = publishing.open(chain, this)) {
      LiveRun run = new LiveRun(this, camera, chain, published.sinks());
      LiveRun.run(List.of(run), cameras.durationS());
      run.summary();
    }
  }
}
