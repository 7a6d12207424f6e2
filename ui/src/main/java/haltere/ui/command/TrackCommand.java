package haltere.ui.command;

import haltere.core.chain.ChainFile;
import haltere.core.chain.ChainStage;
import haltere.core.chain.ConfigurableFilter;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.chain.Outlet;
import haltere.core.event.SensorGeometry;
import haltere.core.pipeline.JobResults;
import haltere.core.pipeline.RecordingJob;
import haltere.core.pipeline.ResultFiles;
import haltere.core.sink.TableMetadata;
import haltere.filters.object.ObjectTrack;
import haltere.filters.object.ObjectTrackerFilter;
import haltere.filters.object.ObjectTrackerSettings;
import haltere.filters.plane.PlanePoint;
import haltere.filters.road.LineCounter;
import haltere.filters.road.LineCrossing;
import haltere.filters.track.KalmanTracksFilter;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.TrackPoint;
import haltere.ui.command.results.RoadColumns;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Tracks moving objects and writes their tracks to a table. */
@Command(
    name = "track",
    footer = {"", "Example: haltere track cars.raw --out tracks.csv --report tracks.html"},
    description = {
      "Track moving objects in a recording or of a camera: position, velocity, "
          + "extent and their standard deviations.",
      "TRACKS has a row for each visible object at each tick of the rate, from "
          + "earlier events only. An object is confirmed up to 2 s later."
    })
final class TrackCommand extends Subcommand {
  private static final String OBJECTS = "object-tracker";
  private static final String CLUSTERS = "kalman-tracks";
  private static final double DEFAULT_RATE_HZ = 100;

  @Parameters(arity = "0..1", paramLabel = "FILE", description = CameraOptionsGroup.FILE)
  Path file;

  @Option(
      names = "--out",
      required = true,
      paramLabel = "TRACKS.csv",
      description = "Output table: CSV, or Parquet by its ending, such as TRACKS.parquet.")
  Path out;

  @Option(
      names = "--rate",
      paramLabel = "HZ",
      description = "Rows of each track per second of recording time; default 100.")
  Double rateHz;

  @Option(
      names = "--chain",
      paramLabel = "CHAIN.json",
      description =
          "A chain of filters; one without object-tracker or kalman-tracks gets the first at its "
              + "end. Default: object-tracker alone, which needs no noise filter.")
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
          "A setting of object-tracker (with --preset: of kalman-tracks), see: haltere filters; "
              + "may be repeated.")
  List<String> assignments = List.of();

  @Option(
      names = "--road",
      paramLabel = "ROAD.json",
      description = {
        "Tracks objects on a road along the camera's view, with additional columns in metres. "
            + "Keys, all optional: bridgeHeightM, nearestM, farthestM, vanishingPoint {xPx, yPx}, "
            + "lanes {lanes, leftEdgeM, widthM}, countingLines {lines, firstM, spacingM}, vehicles "
            + "(prior). Or any plane: four points {xPx, yPx, xM, yM}."
      })
  Path roadFile;

  @Option(
      names = "--crossings",
      paramLabel = "CROSSINGS.csv",
      description =
          "Table of crossings of the road's counting lines (--road): time, lane, "
              + "direction, speed and counts.")
  Path crossings;

  @Mixin CameraOptionsGroup cameras;
  @Mixin PublishingOptions publishing;
  @Mixin ReadingOptions reading;
  @Mixin WritingOptions writing;
  @Mixin ReportOptions reporting;

  /** The settings of the preset; null for those of the chain. */
  private KalmanTracksSettings start;

  @Override
  public Integer call() throws IOException {
    boolean isRate = rateHz == null || rateHz >= 0.001 && rateHz <= 100_000;
    checkRange(isRate, "--rate", rateHz, "0.001 to 100000 Hz");
    cameras.checkOneSource(file);
    reading.checkNeeded(file, "--report");
    publishing.check();
    checkNeeded(roadFile != null, "--road", "--crossings");
    writing.check(
        Arrays.asList(file, chainFile, roadFile), Arrays.asList(out, crossings, reporting.report));
    if (preset != null) {
      checkNeeded(chainFile == null, "no --chain, which also says how to track", "--preset");
      start = preset(new KalmanTracksFilter.Provider(), preset);
    }
    if (cameras.given()) {
      cameras.run(false, this::chain, (camera, chain) -> results(chain));
    } else {
      RecordingJob job =
          RecordingJob.of(file, this::chain, (reader, chain) -> results(chain))
              .withReading(reading.readOptions(), reading.strict)
              .withOpening(reading::open);
      reporting.write(run(reporting.watching(job), "tracking", file), List.of(), writing.overwrite);
    }
    return OK;
  }

  private JobResults results(FilterChain chain) throws IOException {
    // the added tracker is published too
    return JobResults.all(() -> tables(chain), () -> publishing.open(chain, this));
  }

  private FilterChain chain(SensorGeometry geometry) throws IOException {
    if (chainFile == null) {
      FilterChain chain = new FilterChain(geometry);
      (start == null ? List.of(OBJECTS) : List.of("background-activity", "hot-pixels", CLUSTERS))
          .forEach(name -> chain.add(Filters.named(name)));
      return chain;
    }
    return ChainFile.read(chainFile, geometry, this::warning);
  }

  /** The road, or null without one. */
  private RoadFile road() throws IOException {
    if (roadFile == null) {
      return null;
    }
    RoadFile road = RoadFile.read(roadFile, this::warning);
    if (crossings != null && road.lines().lines() == 0) {
      throw new CommandProblem(roadFile + ": there are no counting lines for --crossings");
    }
    return road;
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

  private JobResults tables(FilterChain chain) throws IOException {
    TableMetadata metadata = provenance(file).chain(chain);
    boolean isWithout = last(chain, ObjectTrackerFilter.class) == null;
    KalmanTracksFilter clusters = last(chain, KalmanTracksFilter.class);
    if (isWithout && clusters != null) {
      return ResultFiles.open(writing::begin, metadata, files -> trackClusters(clusters, files));
    }
    if (isWithout) {
      chain.add(Filters.named(OBJECTS));
    }
    ObjectTrackerFilter tracker = last(chain, ObjectTrackerFilter.class);
    tracker.apply(assigned(ObjectTrackerSettings.class, tracker.settings(), "reportRateHz"));
    return ResultFiles.open(
        writing::begin, metadata, files -> trackObjects(tracker, chain.geometry(), files));
  }

  private void trackObjects(ObjectTrackerFilter objects, SensorGeometry geometry, ResultFiles files)
      throws IOException {
    RoadFile road = road();
    if (road == null) {
      files.write(objects.tracks(), out);
      return;
    }
    Function<ObjectTrack, Optional<PlanePoint>> onRoad = road.objects(geometry);
    objects.apply(road.motion(geometry));
    Outlet<RoadColumns.OfObject> rows = onRoad(files, RoadColumns.OfObject.class);
    Consumer<PlanePoint> counter = counter(road, files);
    files.subscribe(
        objects.tracks(),
        track -> {
          Optional<PlanePoint> point = onRoad.apply(track);
          if (point.isPresent()) {
            RoadColumns columns = RoadColumns.of(point.get(), road.lanes());
            rows.publish(new RoadColumns.OfObject(track, columns));
            counter.accept(point.get());
          }
        });
  }

  private void trackClusters(KalmanTracksFilter tracks, ResultFiles files) throws IOException {
    KalmanTracksSettings settings = start == null ? tracks.settings() : start;
    RoadFile road = road();
    if (road != null) {
      settings = settings.onRoad(road.tracks(settings.road()));
    }
    tracks.apply(assigned(KalmanTracksSettings.class, settings, "clusters.output.reportRateHz"));
    if (road == null) {
      files.write(tracks.points(), out);
      return;
    }
    Outlet<RoadColumns.OfTrack> rows = onRoad(files, RoadColumns.OfTrack.class);
    // A track's position in the picture is published before its position on the road.
    TrackPoint[] inPicture = new TrackPoint[1];
    files.subscribe(tracks.points(), point -> inPicture[0] = point);
    files.subscribe(
        tracks.roadPoints(),
        point ->
            rows.publish(
                new RoadColumns.OfTrack(inPicture[0], RoadColumns.of(point, road.lanes()))));
    files.subscribe(tracks.roadPoints(), counter(road, files));
  }

  /** Results on the road, which go to the table and the report. */
  private <R extends Record> Outlet<R> onRoad(ResultFiles files, Class<R> type) throws IOException {
    Outlet<R> rows = new Outlet<>("road", type);
    files.write(rows, out);
    reporting.plot(rows, "x_m", "y_m", "speed_km_h");
    return rows;
  }

  private Consumer<PlanePoint> counter(RoadFile road, ResultFiles files) throws IOException {
    return crossings == null
        ? point -> {}
        : new LineCounter(road.lanes(), road.lines(), files.table(crossings, LineCrossing.class));
  }

  private <S extends Record> S assigned(Class<S> type, S settings, String rate) {
    S usual = assigned(type, settings, Map.of(rate, DEFAULT_RATE_HZ), List.of());
    return assigned(type, usual, rateHz == null ? Map.of() : Map.of(rate, rateHz), assignments);
  }
}
