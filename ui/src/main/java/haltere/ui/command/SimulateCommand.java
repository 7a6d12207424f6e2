package haltere.ui.command;

import haltere.core.event.EventPacket;
import haltere.core.format.RecordingWriter;
import haltere.core.simulation.Scene;
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
import java.util.List;
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
  private static final long DEFAULT_DURATION_US = 10_000_000;

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
    boolean isRate = rateHz == null || rateHz > 0 && rateHz <= 1e6;
    checkRange(isRate, "--rate", rateHz, "above 0 and at most 1000000 Hz");
    checkDuration(durationS);
    checkNeeded(truth != null, "--truth", "--rate");
    try (Scene<?> scene = scene()) {
      writing.checkRecording(out);
      writing.check(List.of(), Arrays.asList(out, truth, observations, cameras));
      FlightFiles flight = flight(scene);
      write(scene);
      if (flight != null) {
        flight
            .write(scene.startUs() + lengthUs(scene), writing.overwrite, metadata())
            .forEach(this::message);
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
      return Scenes.named(sceneName).create(assignments);
    } catch (IllegalArgumentException problem) {
      throw wrongArguments(problem.getMessage());
    }
  }

  private <T extends Record> void write(Scene<T> scene) throws IOException {
    long endUs = scene.startUs() + lengthUs(scene);
    long events;
    long rows = 0;
    try (RecordingWriter writer = writing.create(out, scene.geometry());
        TableSink<T> table =
            truth == null
                ? null
                : Tables.create(truth, scene.truthType(), writing.overwrite, metadata())) {
      events = writeEvents(scene, endUs, writer);
      warnings(out, writer.losses());
      if (table != null) {
        rows = writeTruth(scene, endUs, table);
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

  private long lengthUs(Scene<?> scene) {
    long asked = durationS == null ? Long.MAX_VALUE : Math.round(durationS * 1e6);
    long own = scene.durationUs().orElse(durationS == null ? DEFAULT_DURATION_US : Long.MAX_VALUE);
    return Math.min(asked, own);
  }

  private long writeEvents(Scene<?> scene, long endUs, RecordingWriter writer) throws IOException {
    try (ProgressBar bar = progressBar("simulating", out)) {
      UntilTime sink = new UntilTime(writer, scene.startUs(), endUs, bar);
      while (!sink.full && scene.next(sink)) {
        checkInterrupted("simulating");
      }
      return sink.events;
    } catch (UncheckedIOException problem) {
      throw problem.getCause();
    }
  }

  private <T extends Record> long writeTruth(Scene<T> scene, long endUs, TableSink<T> table)
      throws IOException {
    double rate = rateHz == null ? scene.truthRateHz() : rateHz;
    long timeUs = scene.startUs();
    for (long row = 1; timeUs < endUs; row++) {
      checkInterrupted("simulating");
      scene.truthRows(timeUs).forEach(table);
      timeUs = scene.startUs() + Math.round(row * 1e6 / rate);
    }
    return table.rows();
  }

  static final class SceneNames implements Iterable<String> {
    @Override
    public Iterator<String> iterator() {
      return Scenes.all().keySet().iterator();
    }
  }

  /** Writes events up to a time. */
  private static final class UntilTime implements StreamHandler {
    private final RecordingWriter writer;
    private final long startUs;
    private final long endUs;
    private final ProgressBar bar;
    private long events;
    private boolean full;

    UntilTime(RecordingWriter writer, long startUs, long endUs, ProgressBar bar) {
      this.writer = writer;
      this.startUs = startUs;
      this.endUs = endUs;
      this.bar = bar;
    }

    @Override
    public void packet(EventPacket packet) {
      if (packet.isEmpty()) {
        return;
      }
      bar.events(events);
      bar.progress(packet.lastTimeUs() - startUs, endUs - startUs);
      int kept = packet.indexAtOrAfter(endUs);
      full = kept < packet.size();
      packet.truncate(kept);
      events += kept;
      Unchecked.write(() -> writer.write(packet));
    }
  }
}
