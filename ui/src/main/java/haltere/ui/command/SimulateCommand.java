package haltere.ui.command;

import haltere.core.format.RecordingWriter;
import haltere.core.settings.SettingsSchema;
import haltere.core.simulation.Scene;
import haltere.core.simulation.SceneProvider;
import haltere.core.simulation.Scenes;
import haltere.core.simulation.internal.flight.FlightScene;
import haltere.core.sink.TableMetadata;
import haltere.core.sink.TableSink;
import haltere.core.sink.Tables;
import haltere.core.sink.internal.Unchecked;
import haltere.core.stream.StreamHandler;
import haltere.ui.command.results.FlightFiles;
import haltere.ui.command.terminal.ProgressBar;
import haltere.ui.command.terminal.Quantities;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Writes a synthetic recording and its ground truth. */
@Command(
    name = "simulate",
    footer = {"", "Example: haltere simulate fly fly.aedat4 --truth truth.csv"},
    description =
        "Write a synthetic recording and its ground truth. The same settings give the same events.")
final class SimulateCommand extends Subcommand {
  /** Length of a scene whose settings and options give none. */
  private static final String DEFAULT_DURATION = "durationS=10";

  @Parameters(
      index = "0",
      paramLabel = "SCENE",
      completionCandidates = SceneNames.class,
      description = "The scene: ${COMPLETION-CANDIDATES}.")
  String sceneName;

  @Parameters(
      index = "1",
      paramLabel = "OUT",
      description = "Output recording; its ending gives the format.")
  Path out;

  @Option(names = "--truth", paramLabel = "TRUTH.csv", description = "Table of the ground truth.")
  Path truth;

  @Option(
      names = "--observations",
      paramLabel = "OBSERVATIONS.csv",
      description = "Table of all cameras' observations, for haltere orient; scene flight only.")
  Path observations;

  @Option(
      names = "--cameras",
      paramLabel = "CAMERAS.json",
      description = "Output file for the calibrated cameras; scene flight only.")
  Path cameras;

  @Option(
      names = "--set",
      paramLabel = "name=value",
      description =
          "A setting of the scene; may be repeated. haltere scenes lists them; the "
              + "last part of a name is enough if it is unique.")
  List<String> assignments = List.of();

  @Option(
      names = "--rate",
      paramLabel = "HZ",
      description = "Rows of ground truth per second; default: the scene's setting.")
  Double rateHz;

  @Option(
      names = "--duration",
      paramLabel = "S",
      description = "Length in seconds; default: the scene's setting, else 10.")
  Double durationS;

  @Mixin RecordingWritingOptions writing;

  @Override
  public Integer call() throws IOException {
    boolean isRate = rateHz == null || rateHz >= 0.1 && rateHz <= 1e6;
    checkRange(isRate, "--rate", rateHz, "0.1 to 1000000 Hz");
    checkDuration(durationS);
    checkNeeded(truth != null, "--truth", "--rate");
    try (Scene<?> scene = scene()) {
      writing.checkRecording(out);
      writing.check(List.of(), Arrays.asList(out, truth, observations, cameras));
      FlightFiles flight = flight(scene);
      write(scene);
      if (flight != null) {
        flight.write(endUs(scene), writing.overwrite, metadata()).forEach(this::message);
      }
    }
    return OK;
  }

  /** Outputs of several cameras, or null for none. */
  private FlightFiles flight(Scene<?> scene) {
    boolean isFlight = scene instanceof FlightScene;
    checkNeeded(
        isFlight, "the scene flight, as others have one camera", "--observations", "--cameras");
    boolean isNone = observations == null && cameras == null;
    return isNone ? null : new FlightFiles((FlightScene) scene, observations, cameras);
  }

  private Scene<?> scene() {
    try {
      return scene(Scenes.named(sceneName));
    } catch (IllegalArgumentException problem) {
      throw wrongArguments(problem.getMessage());
    }
  }

  private <S extends Record> Scene<?> scene(SceneProvider<S> provider) {
    Map<String, Object> options = new LinkedHashMap<>();
    options.put("durationS", durationS);
    options.put("truthRateHz", rateHz);
    SettingsSchema<S> schema = provider.schema();
    S settings = assigned(provider.settingsType(), schema.defaults(), options, assignments);
    Scene<?> scene = provider.create(settings);
    if (scene.durationUs().isPresent()) {
      return scene;
    }
    scene.close();
    return provider.create(schema.withAssignments(settings, List.of(DEFAULT_DURATION)));
  }

  private <T extends Record> void write(Scene<T> scene) throws IOException {
    long events;
    long rows = 0;
    try (RecordingWriter writer = writing.create(out, scene.geometry());
        TableSink<T> table =
            truth == null
                ? null
                : Tables.create(truth, scene.truthType(), writing.overwrite, metadata())) {
      events = writeEvents(scene, writer);
      warnings(out, writer.losses());
      if (table != null) {
        rows = writeTruth(scene, table);
        table.finish();
      }
      writer.finish();
    }
    message("wrote " + out + " (" + Quantities.events(events) + ")");
    if (truth != null) {
      wrote(truth, rows);
    }
  }

  private TableMetadata metadata() {
    return provenance(null)
        .with("haltere.scene", () -> sceneName)
        .with("haltere.settings", () -> String.join(" ", assignments));
  }

  private static long endUs(Scene<?> scene) {
    return scene.startUs() + scene.durationUs().getAsLong();
  }

  private long writeEvents(Scene<?> scene, RecordingWriter writer) throws IOException {
    AtomicLong events = new AtomicLong();
    try (ProgressBar bar = progressBar("simulating", out)) {
      StreamHandler sink =
          packet -> {
            if (!packet.isEmpty()) {
              bar.events(events.getAndAdd(packet.size()));
              bar.progress(packet.lastTimeUs() - scene.startUs(), scene.durationUs().getAsLong());
              Unchecked.write(() -> writer.write(packet));
            }
          };
      while (scene.next(sink)) {
        checkInterrupted("simulating");
      }
    } catch (UncheckedIOException problem) {
      throw problem.getCause();
    }
    return events.get();
  }

  private <T extends Record> long writeTruth(Scene<T> scene, TableSink<T> table)
      throws IOException {
    for (long row = 0; scene.truthTimeUs(row) < endUs(scene); row++) {
      checkInterrupted("simulating");
      scene.truthRows(scene.truthTimeUs(row)).forEach(table);
    }
    return table.rows();
  }

  static final class SceneNames implements Iterable<String> {
    @Override
    public Iterator<String> iterator() {
      return Scenes.all().keySet().iterator();
    }
  }
}
